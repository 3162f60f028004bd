// `lippmann view [IN [OTHER]]`: opens a page that shows or compares light fields, sets up a scene, or accepts dropped pictures.
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/page_server.hpp"
#include "apps/lippmann/print.hpp"
#include "apps/lippmann/progress.hpp"
#include "apps/lippmann/scene_to_set_up.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"
#include "formats/rendered.hpp"
#include "job/job_folder.hpp"
#include "lippmann/core/error.hpp"
#include "live/live_page.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string in, other, save;
  LightFieldFlags field;
  SceneToSetUpFlags scene;
  PageServerFlags server;
  int threads = 0;
};

std::vector<std::unique_ptr<PageField>> read_fields(const ViewOptions& options, const Context& context) {
  std::vector<std::unique_ptr<PageField>> fields;
  for (const std::string& in : {options.in, options.other})
    if (!in.empty()) warn_about_unchecked_files(in, context);
  fields.push_back(std::make_unique<PageField>(options.in, options.field.read(), context));
  if (!options.other.empty()) fields.push_back(std::make_unique<PageField>(options.other, options.field.read(), context));
  for (const auto& field : fields)
    if (!field->facts().assumption.empty()) context.warning(field->facts().assumption);
  return fields;
}

void refuse_server_flags(const PageServerFlags& server) {
  const auto refuse = [](bool given, const char* flag) {
    if (given) throw usage_error(flag, "has no effect with --save, which starts no server", "lippmann view without --save");
  };
  refuse(server.port.has_value(), "--port");
  refuse(server.host != PageServerFlags{}.host, "--host");
  refuse(server.open, "--open");
}

/// Saves the page to a folder, or to a file if the path ends in .html, and shows the progress.
SavedPage save_with_progress(const std::vector<std::unique_ptr<PageField>>& fields, const fs::path& path,
                             const Context& context) {
  std::size_t frames = 0;
  for (const auto& field : fields) frames += field->facts().frames.size();
  Progress progress(static_cast<int>(frames), Progress::usual_style());
  const FrameSaved saved = [&](const std::string& label) { progress.step(fmt::format("frame {}", label)); };
  return path.extension() == ".html" ? save_page_file(fields, path, context, saved) : save_page(fields, path, context, saved);
}

int save(const ViewOptions& options, const Context& context) {
  refuse_server_flags(options.server);
  const std::vector<std::unique_ptr<PageField>> fields = read_fields(options, context);
  const SavedPage page = save_with_progress(fields, options.save, context);
  if (page.index.empty()) return 0;
  const std::string index = printable_line(page.index.string());
  fmt::print("{}: {:.1f} MB{}\n", index, 1e-6 * double(page.bytes), page.files.size() > 1 ? " with all files beside it" : "");
  std::fflush(stdout);
  print_error("Open {} in a browser.\n", index);
  return 0;
}

/// Returns whether IN is the folder of a running render that has written its first report, and no other flag is given.
bool is_render_to_watch(const ViewOptions& options) {
  const LightFieldFlags& field = options.field;
  const bool is_alone = options.other.empty() && field.from.empty() && field.report.empty() && field.views.empty() &&
                        field.quilt.empty() && field.display.empty() && !field.sheet.are_given() && !field.view_angle_deg &&
                        !field.cone_ends;
  return is_alone && fs::exists(fs::path(options.in) / "report.json") && is_unfinished_render(options.in);
}

int watch(const ViewOptions& options, const Context& context) {
  const ToolCommand resuming{platform::program_file(), words_to_resume(options.in)};
  auto render = std::make_shared<RunningRender>(options.in, resuming);
  auto field = std::make_unique<PageField>(options.in, render, context);
  return serve_page(std::move(field), std::move(render), options.server, context);
}

int set_up(const ViewOptions& options, const Context& context) {
  if (!options.other.empty())
    throw usage_error("OTHER", "needs a light field as IN, but IN is a scene", "a rendered folder as IN");
  if (!options.save.empty())
    throw usage_error("--save", "needs a light field, but IN is a scene", "lippmann render SCENE --page");
  const RenderParams params = scene_params(options.in, options.scene, options.field, options.threads);
  auto scene =
      std::make_unique<LiveScene>(first_settings(params, options.in), job_file_for(options.scene, params), context.warn);
  return serve_page(std::make_unique<LiveAnswers>(std::move(scene)), options.server, context);
}

void refuse_flags_without_in(const ViewOptions& options) {
  const LightFieldFlags& field = options.field;
  const auto refuse = [](bool given, const std::string& flag) {
    if (given) throw usage_error(flag, "has no effect without IN", "lippmann view IN");
  };
  refuse(!options.save.empty(), "--save");
  refuse(!field.from.empty(), "--from");
  refuse(!field.views.empty(), "--views");
  refuse(!field.quilt.empty(), "--quilt");
  refuse(!field.display.empty(), "--display");
  refuse(field.sheet.are_given(), field.sheet.first_given());
  refuse(!field.report.empty(), "--report");
  refuse(field.view_angle_deg.has_value(), "--view-angle");
  refuse(field.cone_ends, "--cone-ends");
  refuse(!options.scene.job_file.empty(), "--save-job");
  for (const auto& [name, values] : options.scene.params.values) refuse(!values.empty(), fmt::format("--{}", name));
}

int await_pictures(const ViewOptions& options, const Context& context) {
  refuse_flags_without_in(options);
  return serve_page(std::make_shared<DroppedPictures>(context), options.server, context);
}

int run(const ViewOptions& options, Context& context) {
  context.threads = options.threads;
  if (options.in.empty()) return await_pictures(options, context);
  if (is_scene_to_set_up(options.in)) return set_up(options, context);
  refuse_scene_flags(options.in, options.scene);
  if (!options.save.empty()) return save(options, context);
  if (is_render_to_watch(options)) return watch(options, context);
  return serve_page(read_fields(options, context), std::nullopt, options.server, context);
}

}  // namespace

void add_view_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ViewOptions>();
  const Command command =
      root.add_command("view", "Show a light field in the browser, or set up a scene there: eyes, time, focus, comparison");
  command.footer("The server gives access to no file outside IN and OTHER; see docs/guide/view.md.");
  command.add_option(
      "IN", options->in,
      "A rendered picture, a folder of frames, or any light field that `lippmann convert` reads; or a scene or a job, "
      "as for `lippmann render`. Default: an empty page, on which pictures are dropped");
  command.add_option("OTHER", options->other,
                     "A light field to compare with IN: with a wipe, side by side, or as a difference");
  add_page_server_flags(command, options->server);
  command
      .add_option(
          "--save", options->save,
          "Write the page and its data to a folder for a disk or any web server instead of serving it; to a single file if "
          "the name ends in .html")
      .type_name("FOLDER|FILE.html");
  add_light_field_flags(command, options->field);
  add_report_flags(command, options->field, "; for a scene: the display to render for");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  add_scene_to_set_up_flags(command, options->scene,
                            {"display", "views", "quilt", "view-angle", "cone-ends", "threads", "resume", "also", "page"});
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
