// `lippmann render SCENE`: renders the scene or job, and prints progress and a summary.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/crosstalk_flags.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/print.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/render_progress.hpp"
#include "apps/lippmann/write_page.hpp"
#include "core/folder.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"
#include "job/animation.hpp"
#include "job/job_file.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_sentence.hpp"
#include "job/single_clip.hpp"
#include "job/size_estimate.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "optics/view_spacing.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  ParamFlags flags;
  std::string dump_job, progress, unit, only_frames, program;
  bool force = false;
  bool json = false, quiet = false, verbose = false, dry_run = false;

  bool is_part() const { return !unit.empty() || !only_frames.empty(); }
};

std::string part_flag(const RenderOptions& options) {
  return options.unit.empty() ? " --only-frames " + options.only_frames : " --unit " + options.unit;
}

/// A copy of the data that the summary needs after the RenderPlan was destroyed.
struct Planned {
  fs::path folder;
  FrameNames names;
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  int kept = 0;
};

std::string describe_pictures(const Planned& plan) {
  return fmt::format("{}{}x{} pixels", plan.pictures_per_frame > 1 ? fmt::format("{} views of ", plan.pictures_per_frame) : "",
                     plan.picture_size.x, plan.picture_size.y);
}

/// Returns whether `lippmann replay` can show what an eye sees of the rendered pictures.
bool can_be_replayed(const RenderReport& report) {
  return !is_single_view(report.optics) && !sensor_lenses(report.optics) && !report.params.output.pictures.mirror;
}

std::string describe_paths(const Sampling& sampling) {
  const int samples = samples_per_pixel(sampling);
  const bool denoised = is_denoised(sampling);
  return fmt::format("path traced with {} sample{} a pixel{}; --spp {} for less noise", samples, samples == 1 ? "" : "s",
                     denoised ? ", denoised" : "", 4 * samples);
}

std::string describe_depth(const ShownDepth& shown, const Optics& optics, float depth_scale) {
  return depth_budget_sentence(shown, optics, depth_scale) +
         (depth_scale < 1.0f ? " --full-depth shows its full depth." : " --fit-depth scales its depth to the budget.");
}

void print_line(std::string_view name, const std::string& value) { print_out("  {:<9} {}\n", name, printable_line(value)); }

void print_choices(const Sampling& sampling, const Optics& optics, const std::string& light, const std::string& view) {
  if (const std::string spacing = view_spacing(optics); !spacing.empty()) print_line("eyes", spacing);
  if (facts_of(sampling).is_stochastic) print_line("shading", describe_paths(sampling));
  if (!light.empty()) print_line("light", light);
  if (!view.empty()) print_line("view", view);
}

std::string first_and_last(const std::string& first, const std::string& last) {
  return first == last ? first : first + " ... " + last;
}

std::string count_of(std::size_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

/// Prints the results and commands to view them. Each command is on its own line, so that it can be copied.
void print_summary(const RenderReport& report, const Planned& plan, const RenderOptions& options) {
  const std::string& program = options.program;
  const auto& [folder, names, picture_size, pictures_per_frame, kept] = plan;
  const std::size_t frames = report.frames.size();
  double seconds = 0.0, rays = 0.0;
  for (const auto* some : {&report.frames, &report.strips, &report.run.sources})
    for (const FrameReport& frame : *some) seconds += frame.seconds, rays += static_cast<double>(frame.rays.total());
  const std::string made =
      frames == 0 && !report.strips.empty() ? count_of(report.strips.size(), "strip") : count_of(frames, "frame");
  print_out("{}{} of {}: {:.1f} s of rendering, {:.1f} million rays/s{}\n", report.interrupted ? "Stopped after " : "", made,
            describe_pictures(plan), seconds, rays * 1e-6 / std::max(seconds, 1e-9),
            kept > 0 ? fmt::format(" ({} kept from before)", kept) : "");
  if (frames > 0) {
    const auto path = [&in = folder, &called = names](const FrameReport& frame) {
      return (in / frame_name(called, frame.frame)).string();
    };
    print_line("pictures", first_and_last(path(report.frames.front()), path(report.frames.back())));
    if (!report.interrupted)
      for (const std::string& video : report.videos) {
        print_line("video", video);
        print_line("play", "ffplay -loop 0 " + shell_word(video));
      }
    if (frames > 1 || !std::holds_alternative<CopySettled>(report.reuse)) print_line("reuse", reuse_sentence(report));
    if (const std::string error = error_sentence(report.frames); !error.empty()) print_line("quality", error);
    if (can_be_replayed(report)) {
      print_line("one eye", program + " replay " + shell_word(folder.string()));
      print_line("in 3D", program + " view " + shell_word(folder.string()));
    }
    if (sensor_lenses(report.optics))
      print_line("views", program + " convert " + shell_word(folder.string()) + " views --to views");
  }
  print_choices(report.params.sampling, report.optics, report.light, report.view);
  if (const auto done = precompensation_of(report))
    print_line("crosstalk", fmt::format("{:.1f} % of each neighbour undone; {}", 100.0 * neighbour_share(*report.crosstalk_px),
                                        describe_bound(done->clipped_share, done->largest_residual)));
  if (report.depth_scale < 1.0f || !report.depth.fits())
    print_line("depth", describe_depth(report.depth, report.optics, report.depth_scale));
  print_line("figures", (folder / "report.json").string());
  const std::string again = program + " render " + shell_word((folder / "job.toml").string());
  if (report.interrupted)
    print_line("go on", again + " --resume" + (options.is_part() ? part_flag(options) : ""));
  else if (!options.is_part())
    print_line("again", again);
  else
    print_line("then", fmt::format("{} finish {}   (when all frames are there)", program, shell_word(folder.string())));
}

std::string describe_frames(const std::vector<int>& frames) {
  if (frames.size() == 1) return fmt::format("1 frame ({})", frames.front());
  return fmt::format("{} frames ({} to {})", frames.size(), frames.front(), frames.back());
}

std::string describe_parts(const FileSizes& sizes) {
  std::string parts;
  if (sizes.layers > 0.0) parts += ", layers " + bytes_text(sizes.layers);
  if (sizes.videos > 0.0) parts += ", videos " + bytes_text(sizes.videos);
  return parts.empty() ? parts : ", of which" + parts.substr(1);
}

void print_plan(const RenderPlan& plan, const RenderParams& params, bool json) {
  const std::uint64_t bytes = largest_picture_bytes(plan, params.output.pictures.exr_pixels);
  const FileSizes sizes = estimated_file_sizes(plan, params);
  const PlacedOptics& placed = plan.stage.placed;
  const ShownDepth shown = shown_depth(plan.stage.array, placed.units_per_mm, placed.depth_scale, placed.optics);
  const int pictures = plan.pictures_per_frame;
  const auto whole = [](double number) { return static_cast<std::uint64_t>(number); };
  if (json)
    return print_json(
        {{"dry_run", true},
         {"folder", plan.folder.string()},
         {"frames", plan.frames},
         {"picture_size", {plan.picture_size.x, plan.picture_size.y}},
         {"pictures_per_frame", pictures},
         {"largest_bytes", bytes},
         {"light", plan.stage.light},
         {"view", plan.stage.array.how},
         {"depth", depth_json(shown, placed.depth_scale, placed.optics)},
         {"estimated_bytes", whole(sizes.all())},
         {"estimated_memory_bytes", whole(plan.memory_bytes)},
         {"bands", plan.bands},
         {"estimated",
          {{"pictures", whole(sizes.pictures)}, {"layers", whole(sizes.layers)}, {"videos", whole(sizes.videos)}}}});
  print_out("Would render {} to {}{}\n", describe_frames(plan.frames), printable_line(plan.folder.string()),
            plan.folder.empty() ? "." : "");
  print_line("pictures", fmt::format("{}{}x{} pixels", pictures > 1 ? fmt::format("{} a frame, ", pictures) : "",
                                     plan.picture_size.x, plan.picture_size.y));
  print_line("files", first_and_last(frame_name(plan.names, plan.frames.front()), frame_name(plan.names, plan.frames.back())));
  print_line("size", fmt::format("about {}{} (an estimate); pictures before compression: {}", bytes_text(sizes.all()),
                                 describe_parts(sizes), bytes_text(static_cast<double>(bytes))));
  print_line("memory", fmt::format("about {} for frames, beside the scene{}", bytes_text(plan.memory_bytes),
                                   plan.bands > 1 ? fmt::format("; in {} bands of rows", plan.bands) : ""));
  print_choices(params.sampling, placed.optics, plan.stage.light, plan.stage.array.how);
  if (placed.depth_scale < 1.0f || !shown.fits()) print_line("depth", describe_depth(shown, placed.optics, placed.depth_scale));
}

RunParams run_params(const RenderOptions& options, Ranks* ranks) {
  RunParams run;
  run.force = options.force;
  run.ranks = ranks;
  if (!options.unit.empty()) run.units = read_units(options.unit, "unit");
  if (!options.only_frames.empty()) run.only_frames = read_frames(options.only_frames, "only-frames");
  return run;
}

void plan_only(const ResolvedJob& job, const RenderOptions& options, const Context& context) {
  const RenderSetup setup(job, run_params(options, nullptr), context);
  print_plan(setup.plan(0), job.params(), options.json);
}

bool is_first(const Ranks* ranks) { return !ranks || ranks->rank() == 0; }

RenderProgressKind progress_kind(const RenderOptions& options, const Ranks* ranks) {
  if (options.quiet || !is_first(ranks)) return RenderProgressKind::kNone;
  if (options.verbose) return RenderProgressKind::kVerbose;
  return options.progress == "json" ? RenderProgressKind::kJson : RenderProgressKind::kAuto;
}

RenderReport render(const ResolvedJob& job, const RenderOptions& options, Ranks* ranks, Context& context) {
  std::optional<RenderProgress> progress;
  Planned planned;
  RenderObserver observer;
  observer.planned = [&](const RenderPlan& plan) {
    planned = {plan.folder, plan.names, plan.picture_size, plan.pictures_per_frame, plan.kept};
    progress.emplace(plan, job.params(), progress_kind(options, ranks));
  };
  observer.traced = [&](const FrameReport& frame) { progress->traced(frame); };
  observer.written = [&](int frame, std::uintmax_t bytes) { progress->written(frame, bytes); };
  context.frame_progress = [&](double share) { progress->within(share); };
  const RenderReport report = render_animation(job, context, observer, run_params(options, ranks));
  context.frame_progress = nullptr;
  progress.reset();
  const bool quiet = options.json || options.quiet || !is_first(ranks);
  if (!quiet) print_summary(report, planned, options);
  if (job.output().page && !options.is_part() && !report.interrupted && is_first(ranks)) {
    const SavedPage page = write_page(planned.folder, context);
    if (!quiet && !page.index.empty()) print_line("page", page.index.string());
  }
  return report;
}

void join_in(const RenderOptions& options, const OutputParams& output, const Ranks& ranks, Context& context) {
  if (!options.unit.empty() || output.also)
    throw usage_error(options.unit.empty() ? "also" : "unit", "cannot be combined with mpirun", "one of the two");
  context.threads = threads_of_rank(resolved_threads(context), platform::online_cpus(), local_rank_count());
  if (ranks.rank() > 0) context.warn = {};
}

/// Returns whether the first rank reports the error of this rank. If all ranks fail alike, the first rank stops this rank
/// within 5 s; otherwise this rank must report its error.
bool is_reported_by_first_rank(const Ranks* ranks, const Context& context) {
  if (is_first(ranks) || ranks->has_begun()) return false;
  constexpr int kTenths = 50;
  for (int i = 0; i < kTenths && !context.cancelled; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return context.cancelled;
}

int run(const RenderOptions& options, Context& context) {
  if (options.quiet && (options.verbose || !options.progress.empty()))
    throw usage_error("--quiet", "cannot be combined with --verbose or --progress", "one of the three");
  if (options.verbose && !options.progress.empty())
    throw usage_error("--verbose", "cannot be combined with --progress", "one of the two");
  const ResolvedJob job = options.flags.resolve();
  const OutputParams& output = job.output();
  if (output.page && output.pictures.mirror) throw usage_error("--page", "cannot be combined with --mirror", "one of the two");
  if (!options.dump_job.empty()) {
    make_folder(fs::path(options.dump_job).parent_path());
    write_job(options.dump_job, job.params());
  }
  if (options.dry_run) return plan_only(job, options, context), 0;
  const std::unique_ptr<Ranks> ranks = join_ranks();
  try {
    if (ranks) join_in(options, output, *ranks, context);
    const RenderReport report = render(job, options, ranks.get(), context);
    if (options.json && is_first(ranks.get())) print_json(to_json(report));
    if (output.also == Companion::kSingle && !report.interrupted)
      render(ResolvedJob(single_clip(report.params, report.optics)), options, nullptr, context);
  } catch (const Error& error) {
    if (is_reported_by_first_rank(ranks.get(), context)) return error.exit_code();
    throw;
  }
  return 0;
}

}  // namespace

void add_render_command(const Command& root, Action& chosen, const std::string& program) {
  auto options = std::make_shared<RenderOptions>();
  options->program = program;
  const Command command = root.add_command("render", "Render a scene's animation as integral images");
  add_param_flags(command, options->flags);
  command.add_option("--dump-job", options->dump_job, "Also write a job file that reproduces this render")
      .type_name("FILE")
      .group("Running");
  command
      .add_option(
          "--unit", options->unit,
          "Render the I-th of N parts of the job (or several: 1-3,5/N) into the common folder, on any machine and beside other "
          "parts; then run: lippmann finish DIR")
      .type_name("I/N")
      .group("Running");
  command
      .add_option("--only-frames", options->only_frames,
                  "Render only these frames of the job or the unit: 3, 0-9, 1-3,5,7-10:2; then run: lippmann finish DIR")
      .type_name("RANGES")
      .group("Running");
  command.add_flag("--force", options->force, "Remove the files of another render in the folder, and replace existing videos")
      .group("Running");
  command.add_flag("--json", options->json, "Print the report as JSON on stdout").group("Running");
  command.add_flag("-q,--quiet", options->quiet, "Print neither progress nor a summary; warnings and errors remain")
      .group("Running");
  command.add_flag("-v,--verbose", options->verbose, "Print a line for every frame").group("Running");
  command
      .add_option(
          "--progress", options->progress,
          "json: print one object per line on stderr, before the first frame and after every frame (docs/reference/formats.md)")
      .one_of({"json"})
      .type_name("FORMAT")
      .group("Running");
  command
      .add_flag("-n,--dry-run", options->dry_run,
                "Check the scene and the settings, print the files that would be made and their size, and render nothing")
      .group("Running");
  command.short_help(
      {"--output", "--frames",     "--camera", "--display",    "--optics",  "--lenses",      "--lens-pixels", "--size",
       "--views",  "--full-depth", "--layout", "--integrator", "--spp",     "--environment", "--exposure",    "--format",
       "--video",  "--page",       "--resume", "--force",      "--dry-run", "--quiet",       "--json"},
      "Examples:\n"
      "  lippmann render teapot                                    all 480 frames, into out/teapot\n"
      "  lippmann render examples/desk.glb --frames 0              one frame, path traced\n"
      "  lippmann render room --optics microlens --frames 0        an array of lenslets\n"
      "  lippmann render tree --display portrait --frames 0        for a display (see: lippmann displays)\n"
      "  lippmann render out/teapot/job.toml --resume              resume a stopped render\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
