// `lippmann view IN [OTHER]`: a light field, or two beside each other, in the browser; or a scene, which is set up there.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/page_server.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "job/job_folder.hpp"
#include "lippmann/core/error.hpp"
#include "live/live_page.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string in, other, save, job_file;
  LightFieldFlags field;
  ParamFlags scene;
  PageServerFlags server;
  int threads = 0;
};

/// What exists as a folder is a light field, whatever a built-in scene is called.
bool is_scene(const std::string& in) {
  constexpr std::array<std::string_view, 7> kEndings{".gltf", ".glb", ".dat", ".nff", ".obj", ".ply", ".toml"};
  std::error_code ignored;
  if (fs::is_directory(in, ignored)) return false;
  return is_builtin_scene(in) ||
         std::find(kEndings.begin(), kEndings.end(), fs::path(in).extension().string()) != kEndings.end();
}

// ---- A light field ------------------------------------------------------------------------------------------------------

/// Flags that say how a scene is rendered say nothing of a light field.
void refuse_scene_flags(const ViewOptions& options) {
  if (!options.job_file.empty()) throw usage_error("--save-job", "is for scenes, and IN is a light field", "a scene");
  for (const auto& [name, values] : options.scene.values)
    if (!values.empty())
      throw usage_error(
          fmt::format("--{}", name), fmt::format("is for scenes, and {} is taken for a light field", options.in),
          "a built-in name (see: lippmann scenes), a file (.gltf, .glb, .dat, .nff, .obj, .ply) or a job (.toml)");
}

std::vector<std::unique_ptr<PageField>> read_fields(const ViewOptions& options, const Context& context) {
  std::vector<std::unique_ptr<PageField>> fields;
  fields.push_back(std::make_unique<PageField>(options.in, options.field.read(), context));
  if (!options.other.empty()) fields.push_back(std::make_unique<PageField>(options.other, options.field.read(), context));
  for (const auto& field : fields)
    if (!field->facts().assumption.empty()) context.warning(field->facts().assumption);
  return fields;
}

int save(const ViewOptions& options, const Context& context) {
  const SavedPage page = save_page(read_fields(options, context), options.save, context);
  if (!page.index.empty())
    fmt::print("{}: {:.1f} MB with all files beside it\n", page.index.string(), 1e-6 * double(page.bytes));
  return 0;
}

/// A folder alone, with the report that a render begins with: whatever else is said of it is said of a finished light field.
bool is_render_to_watch(const ViewOptions& options) {
  const LightFieldFlags& field = options.field;
  const bool is_alone = options.other.empty() && field.from.empty() && field.report.empty() && field.views.empty() &&
                        field.quilt.empty() && !field.view_angle_deg;
  return is_alone && fs::exists(fs::path(options.in) / "report.json") && is_unfinished_render(options.in);
}

int watch(const ViewOptions& options, const Context& context) {
  const ToolCommand resuming{fs::canonical("/proc/self/exe"), words_to_resume(options.in)};
  auto render = std::make_shared<RunningRender>(options.in, resuming);
  auto field = std::make_unique<PageField>(options.in, render, context);
  return serve_page(std::move(field), std::move(render), options.server, context);
}

// ---- A scene ------------------------------------------------------------------------------------------------------------

void refuse_light_field_flags(const ViewOptions& options) {
  constexpr const char* kAccepted = "a rendered folder";
  if (!options.other.empty()) throw usage_error("OTHER", "is compared with a light field, and IN is a scene", kAccepted);
  if (!options.save.empty())
    throw usage_error("--save", "needs a light field, and IN is a scene", "lippmann render SCENE --page");
  if (!options.field.from.empty()) throw usage_error("--from", "is for light fields, and IN is a scene", kAccepted);
  if (!options.field.report.empty()) throw usage_error("--report", "is for light fields, and IN is a scene", kAccepted);
}

/// Flags that a light field has, too.
ParamFlags scene_flags(const ViewOptions& options) {
  ParamFlags flags = options.scene;
  flags.scene = options.in;
  if (!options.field.views.empty()) flags.values["views"] = {options.field.views};
  if (!options.field.quilt.empty()) flags.values["quilt"] = {options.field.quilt};
  if (options.field.view_angle_deg) flags.values["view-angle"] = {fmt::format("{}", *options.field.view_angle_deg)};
  if (options.threads > 0) flags.values["threads"] = {fmt::format("{}", options.threads)};
  return flags;
}

/// SCENE.toml in the working folder.
fs::path job_file_for(const ViewOptions& options, const RenderParams& params) {
  if (!options.job_file.empty()) return options.job_file;
  return fs::path(params.scene.name).stem().string() + ".toml";
}

int set_up(const ViewOptions& options, const Context& context) {
  refuse_light_field_flags(options);
  const RenderParams params = scene_flags(options).read();
  auto scene = std::make_unique<LiveScene>(params, job_file_for(options, params), context.warn);
  return serve_page(std::make_unique<LiveAnswers>(std::move(scene)), options.server, context);
}

int run(const ViewOptions& options, Context& context) {
  context.threads = options.threads;
  if (is_scene(options.in)) return set_up(options, context);
  refuse_scene_flags(options);
  if (!options.save.empty()) return save(options, context);
  if (is_render_to_watch(options)) return watch(options, context);
  return serve_page(read_fields(options, context), std::nullopt, options.server, context);
}

}  // namespace

void add_view_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ViewOptions>();
  const Command command =
      root.add_command("view", "Show a light field in the browser, or set up a scene there: eyes, time, focus, comparison");
  command.footer("Nothing outside IN and OTHER is readable through the server; see docs/view.md.");
  command
      .add_option(
          "IN", options->in,
          "A rendered picture, a folder of frames, or any light field that `lippmann convert` reads; or a scene or a job, "
          "as `lippmann render` takes them")
      .required();
  command.add_option("OTHER", options->other, "Another one, compared with it: wiped, side by side, or as a difference");
  add_page_server_flags(command, options->server);
  command
      .add_option("--save", options->save,
                  "Instead, write the page with all its data into a folder that any web server serves, or a disk")
      .type_name("FOLDER");
  command
      .add_option("--save-job", options->job_file,
                  "Of a scene: the job that Save on the page writes; default: SCENE.toml, or SCENE-2.toml where that is taken")
      .type_name("FILE");
  add_light_field_flags(command, options->field);
  command.add_option("--report", options->field.report, "Path of report.json, if it is not beside the pictures")
      .type_name("FILE");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  add_param_flags_beside(command, options->scene, {"views", "quilt", "view-angle", "threads", "resume"});
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
