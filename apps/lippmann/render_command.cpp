// `lippmann render SCENE`: flags and job file into RenderParams, then render_animation; progress, and what was made.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/progress.hpp"
#include "core/error.hpp"
#include "render/animation.hpp"
#include "render/frame.hpp"
#include "render/job_file.hpp"
#include "render/params_table.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scene, job, dump_job;
  std::map<std::string_view, std::vector<std::string>> flags;  ///< as given, by parameter
  bool json = false;
};

bool is_job(const std::string& scene) { return fs::path(scene).extension() == ".toml"; }

/// A job file first, then what the flags say over it.
RenderParams read_params(const Options& options) {
  RenderParams params;
  const bool scene_is_job = is_job(options.scene);
  if (scene_is_job && !options.job.empty()) throw usage_error("--job", "a second job file", "one");
  if (scene_is_job || !options.job.empty()) read_job(scene_is_job ? options.scene : options.job, params);
  if (!options.scene.empty() && !scene_is_job) params.scene = options.scene;
  for (const auto& [name, values] : options.flags)
    if (!values.empty()) find_param(name)->set(params, values, fmt::format("--{}", name));
  if (params.scene.empty())
    throw usage_error("SCENE", "no scene is named", "a built-in name (see: lippmann scenes), a file, or a job");
  return params;
}

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
  const RenderParams params = read_params(options);
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

void add_param(CLI::App& command, const ParamInfo& info, Options& options) {
  std::vector<std::string>& values = options.flags[info.name];
  const std::string flag = fmt::format("{}--{}", info.name == "output" ? "-o," : "", info.name);
  const std::string doc(info.doc);
  CLI::Option* option = nullptr;
  if (info.kind == ParamKind::kFlag) {
    option = command.add_flag_callback(
        flag, [&values] { values = {"true"}; }, doc);
  } else {
    option = command.add_option(flag, values, doc)->type_name(std::string(info.type))->allow_extra_args(false);
    if (info.kind != ParamKind::kList) option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  }
  const std::vector<std::string> standard = info.get(RenderParams{});
  if (info.kind != ParamKind::kFlag && !standard.empty()) option->default_str(standard.front());
  option->group(std::string(info.group));
}

}  // namespace

void add_render_command(CLI::App& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *root.add_subcommand("render", "Render a scene's animation as integral images");
  command.add_option("SCENE", options->scene,
                     "A built-in name (see: lippmann scenes), a file (.dat, .gltf, .glb), or a job (.toml)");
  for (const ParamInfo& info : params_table())
    if (info.name != "scene") add_param(command, info, *options);
  command.add_option("--job", options->job, "Take what no flag says from this job file")->type_name("FILE")->group("Running");
  command.add_option("--dump-job", options->dump_job, "Also write the job that reproduces this render")
      ->type_name("FILE")
      ->group("Running");
  command.add_flag("--json", options->json, "Print the report as JSON on stdout")->group("Running");
  command.callback([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
