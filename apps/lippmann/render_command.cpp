// `lippmann render SCENE`: flags and job file into RenderParams, then render_animation; progress, and what was made.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/progress.hpp"
#include "render/animation.hpp"
#include "render/frame.hpp"
#include "render/job_file.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  ParamFlags flags;
  std::string dump_job;
  bool json = false;
};

std::string describe_optics(const Optics& optics) {
  return fmt::format("{}x{} pixels", optics.panel.width, optics.panel.height);
}

std::string frame_line(const FrameReport& frame) {
  return fmt::format("frame {}: {:.3f} s, {:.2f} million rays", frame.frame, frame.seconds,
                     static_cast<double>(frame.rays.total()) * 1e-6);
}

void print_summary(const RenderReport& report, const fs::path& folder, int kept) {
  double seconds = 0.0, rays = 0.0;
  for (const FrameReport& frame : report.frames) seconds += frame.seconds, rays += static_cast<double>(frame.rays.total());
  fmt::print("{}{} frames of {}: {:.1f} s of rendering, {:.1f} million rays/s", report.interrupted ? "Stopped after " : "",
             report.frames.size(), describe_optics(report.optics), seconds, rays * 1e-6 / std::max(seconds, 1e-9));
  if (kept > 0) fmt::print(" ({} kept from before)", kept);
  fmt::print("\n");
  if (report.frames.empty()) return;
  fmt::print("  pictures  {}\n", picture_path(folder, report.frames.front().frame, report.params.format).string());
  if (report.frames.size() > 1)
    fmt::print("       ...  {}\n", picture_path(folder, report.frames.back().frame, report.params.format).string());
  for (const std::string& video : report.params.video)
    if (!report.interrupted) fmt::print("  video     {}\n", video);
  fmt::print("  figures   {}\n", (folder / "report.json").string());
  fmt::print("  again     lippmann render {}{}\n", (folder / "job.toml").string(), report.interrupted ? " --resume" : "");
}

int run(const Options& options, Context& context) {
  const RenderParams params = options.flags.read();
  if (!options.dump_job.empty()) write_job(options.dump_job, params);
  std::optional<Progress> progress;
  fs::path folder;
  int kept = 0;
  RenderObserver observer;
  observer.planned = [&](const RenderPlan& plan) {
    folder = plan.folder;
    kept = plan.kept;
    progress.emplace(plan.frames.last - plan.frames.first + 1 - plan.kept, Progress::stderr_is_terminal());
  };
  observer.traced = [&](const FrameReport& frame) { progress->step(frame_line(frame)); };
  const RenderReport report = render_animation(params, context, observer);
  progress.reset();
  if (options.json)
    fmt::print("{}\n", to_json(report).dump(2));
  else
    print_summary(report, folder, kept);
  return 0;
}

}  // namespace

void add_render_command(CLI::App& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *root.add_subcommand("render", "Render a scene's animation as integral images");
  add_param_flags(command, options->flags);
  command.add_option("--dump-job", options->dump_job, "Also write the job that reproduces this render")
      ->type_name("FILE")
      ->group("Running");
  command.add_flag("--json", options->json, "Print the report as JSON on stdout")->group("Running");
  command.callback([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
