// `lippmann render SCENE`: flags and job file into RenderParams, then render_animation; progress, and what was made.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/crosstalk_flags.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/progress.hpp"
#include "optics/crosstalk.hpp"
#include "render/animation.hpp"
#include "render/frame.hpp"
#include "render/job_file.hpp"
#include "render/shared_light.hpp"
#include "render/single_clip.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  ParamFlags flags;
  std::string dump_job, also;
  bool force = false;
  bool json = false, quiet = false, dry_run = false;
};

std::string describe_optics(const Optics& optics) {
  return fmt::format("{}x{} pixels", optics.panel.width, optics.panel.height);
}

std::string frame_line(const FrameReport& frame, Reuse reuse) {
  if (frame.kind == "in-between" && reuse == Reuse::kForward)
    return fmt::format("frame {}: {:.3f} s, between key frames, {} pixels missed", frame.frame, frame.seconds,
                       frame.missed_pixels);
  if (frame.kind == "in-between")
    return fmt::format("frame {}: {:.3f} s, {} pixels copied from the key frame", frame.frame, frame.seconds,
                       frame.reused_pixels);
  return fmt::format("frame {}: {:.3f} s, {:.2f} million rays", frame.frame, frame.seconds,
                     static_cast<double>(frame.rays.total()) * 1e-6);
}

/// How much of frames that are the same bits as traced ones was copied.
std::string describe_exact_reuse(const RenderReport& report) {
  double reused = 0.0;
  for (const FrameReport& frame : report.frames) reused += static_cast<double>(frame.reused_pixels);
  const double pixels = static_cast<double>(report.optics.panel.width) * report.optics.panel.height;
  return fmt::format("{:.1f} % of all pixels copied from key frames, provably unchanged",
                     100.0 * reused / (pixels * static_cast<double>(report.frames.size())));
}

/// How much was traced and how much interpolated from that.
std::string describe_forward_reuse(const RenderReport& report) {
  std::uint64_t keys = report.sources.size(), made = 0, missed = 0, newly_visible = 0, retraced = 0;
  for (const FrameReport& frame : report.frames) {
    keys += frame.kind == "key";
    made += frame.kind == "in-between";
    missed += frame.missed_pixels, newly_visible += frame.newly_visible_pixels, retraced += frame.retraced_pixels;
  }
  const double pixels = static_cast<double>(report.optics.panel.width) * report.optics.panel.height;
  const double percent = 100.0 / std::max(pixels * static_cast<double>(made), 1.0);
  return fmt::format(
      "{} frames made between {} sources; {:.2f} % of their pixels missed ({:.2f} newly visible, {:.2f} not "
      "covered), {}",
      made, keys, percent * static_cast<double>(missed), percent * static_cast<double>(newly_visible),
      percent * static_cast<double>(missed - newly_visible), retraced > 0 ? "retraced" : "filled");
}

/// What was made, where it is, and how to look at it.
void print_summary(const RenderReport& report, const fs::path& folder, const FrameNames& names, int kept) {
  const std::size_t frames = report.frames.size();
  double seconds = 0.0, rays = 0.0;
  for (const auto* some : {&report.frames, &report.sources})
    for (const FrameReport& frame : *some) seconds += frame.seconds, rays += static_cast<double>(frame.rays.total());
  fmt::print("{}{} frame{} of {}: {:.1f} s of rendering, {:.1f} million rays/s{}\n", report.interrupted ? "Stopped after " : "",
             frames, frames == 1 ? "" : "s", describe_optics(report.optics), seconds, rays * 1e-6 / std::max(seconds, 1e-9),
             kept > 0 ? fmt::format(" ({} kept from before)", kept) : "");
  const auto line = [](std::string_view name, const std::string& value) { fmt::print("  {:<9} {}\n", name, value); };
  if (frames > 0) {
    const auto path = [&](const FrameReport& frame) { return (folder / frame_name(names, frame.frame)).string(); };
    line("pictures", path(report.frames.front()) + (frames > 1 ? " ... " + path(report.frames.back()) : ""));
    for (const std::string& video : report.videos)
      if (!report.interrupted) line("video", video + "   (to look at it: ffplay -loop 0 " + video + ")");
    if (report.params.reuse == Reuse::kForward) line("reuse", describe_forward_reuse(report));
    if (report.params.reuse == Reuse::kExact && integrator_of(report.params) == Integrator::kPath) {
      line("reuse", shared_light_sentence(report.frames));
      if (const std::optional<double> floor = report.params.min_psnr_db)
        for (const std::string& warning :
             {below_floor_sentence(report.frames, *floor), unmeasured_sentence(report.frames, *floor)})
          if (!warning.empty()) line("warning", warning);
    } else if (report.params.reuse == Reuse::kExact && frames > 1) {
      line("reuse", describe_exact_reuse(report));
    }
    if (has_lenses(report.optics))
      line("one eye", "lippmann replay " + folder.string() + " shows what it sees through the lenses");
  }
  if (!report.light.empty()) line("light", report.light);
  if (const auto done = precompensation_of(report))
    line("crosstalk", fmt::format("{:.1f} % of each neighbour undone; {}", 100.0 * neighbour_share(*report.crosstalk_px),
                                  describe_bound(done->clipped_share, done->largest_residual)));
  if (!report.depth.fits())
    line("depth", depth_budget_sentence(report.depth, report.optics) + " --fit-depth shows it less deep.");
  line("figures", (folder / "report.json").string());
  line(report.interrupted ? "go on" : "again",
       "lippmann render " + (folder / "job.toml").string() + (report.interrupted ? " --resume" : ""));
}

/// "3 frames (0 to 8)".
std::string describe_frames(const std::vector<int>& frames) {
  if (frames.size() == 1) return fmt::format("1 frame ({})", frames.front());
  return fmt::format("{} frames ({} to {})", frames.size(), frames.front(), frames.back());
}

void print_plan(const RenderPlan& plan, const RenderParams& params, bool json) {
  const std::uint64_t bytes = largest_picture_bytes(plan, params.exr_pixels);
  const int pictures = std::max(1, plan.names.views);
  if (json)
    return print_json({{"dry_run", true},
                       {"folder", plan.folder.string()},
                       {"frames", plan.frames},
                       {"picture_size", {plan.picture_size.x, plan.picture_size.y}},
                       {"pictures_per_frame", pictures},
                       {"largest_bytes", bytes}});
  fmt::print("Would render {} to {}{}\n", describe_frames(plan.frames), plan.folder.string(), plan.folder.empty() ? "." : "");
  fmt::print("  {:<9} {}{}x{} pixels\n", "pictures", pictures > 1 ? fmt::format("{} a frame, ", pictures) : "",
             plan.picture_size.x, plan.picture_size.y);
  fmt::print("  {:<9} {} ... {}\n", "files", frame_name(plan.names, plan.frames.front()),
             frame_name(plan.names, plan.frames.back()));
  fmt::print("  {:<9} at most {:.1f} MB, before compression\n", "size", static_cast<double>(bytes) * 1e-6);
}

/// Says what a render would make, and makes nothing.
void plan_only(const RenderParams& params, bool json, Context& context) {
  RenderObserver observer;
  observer.only_plan = true;
  observer.planned = [&](const RenderPlan& plan) { print_plan(plan, params, json); };
  render_animation(params, context, observer);
}

/// Renders, with progress on stderr, and says what was made; quiet: neither.
RenderReport render(const RenderParams& params, bool json, bool quiet, bool force, Context& context) {
  std::optional<Progress> progress;
  fs::path folder;
  FrameNames names;
  int kept = 0;
  RenderObserver observer;
  observer.force = force;
  observer.planned = [&](const RenderPlan& plan) {
    folder = plan.folder;
    names = plan.names;
    kept = plan.kept;
    if (!quiet) progress.emplace(static_cast<int>(plan.frames.size()) - plan.kept, Progress::stderr_is_terminal());
  };
  observer.traced = [&](const FrameReport& frame) {
    if (progress) progress->step(frame_line(frame, params.reuse));
  };
  context.frame_progress = [&](double share) {
    if (progress) progress->within(share);
  };
  const RenderReport report = render_animation(params, context, observer);
  context.frame_progress = nullptr;
  progress.reset();
  if (!json && !quiet) print_summary(report, folder, names, kept);
  return report;
}

int run(const Options& options, Context& context) {
  const RenderParams params = with_scene_defaults(options.flags.read());
  if (!options.dump_job.empty()) write_job(options.dump_job, params);
  if (options.dry_run) return plan_only(params, options.json, context), 0;
  const RenderReport report = render(params, options.json, options.quiet, options.force, context);
  if (options.json) print_json(to_json(report));
  if (options.also == "single" && !report.interrupted)
    render(single_clip(params, report.optics), options.json, options.quiet, options.force || params.output.empty(), context);
  return 0;
}

}  // namespace

void add_render_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  const Command command = root.add_command("render", "Render a scene's animation as integral images");
  add_param_flags(command, options->flags);
  command.add_option("--dump-job", options->dump_job, "Also write the job that reproduces this render")
      .type_name("FILE")
      .group("Running");
  command.add_option("--also", options->also, "single: then the same frames as one eye sees them, into DIR/single")
      .one_of({"single"})
      .type_name("WHAT")
      .group("Files");
  command.add_flag("--force", options->force, "Replace another render in the folder: remove the files that its journal names")
      .group("Running");
  command.add_flag("--json", options->json, "Print the report as JSON on stdout").group("Running");
  command.add_flag("-q,--quiet", options->quiet, "Print neither progress nor a summary; warnings and errors remain")
      .group("Running");
  command
      .add_flag("-n,--dry-run", options->dry_run,
                "Check the scene and the settings, say what would be made and how large it is, and make nothing")
      .group("Running");
  command.short_help({"--output", "--frames", "--camera", "--display",    "--optics",  "--lenses",      "--lens-pixels",
                      "--size",   "--views",  "--layout", "--integrator", "--spp",     "--environment", "--exposure",
                      "--format", "--video",  "--resume", "--force",      "--dry-run", "--quiet",       "--json"},
                     "Examples:\n"
                     "  lippmann render teapot                                    all frames, into out/teapot\n"
                     "  lippmann render model.glb --frames 0                     one frame, with all light\n"
                     "  lippmann render room --optics microlens --frames 0        an array of lenslets\n"
                     "  lippmann render tree --display portrait --video tree.mp4  for a display (see: lippmann displays)\n"
                     "  lippmann render out/teapot/job.toml --resume              go on where a render was stopped\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
