// `lippmann play IN --display CAL`: shows a light field or a scene on a calibrated panel, interlaced in the browser.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/page_server.hpp"
#include "apps/lippmann/scene_to_set_up.hpp"
#include "apps/lippmann/view_filter_flags.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/layout/interlace.hpp"
#include "live/live_page.hpp"

namespace lippmann::app {
namespace {

struct PlayOptions {
  std::string in, display;
  ViewFilterFlags filter;
  LightFieldFlags field;
  SceneToSetUpFlags scene;
  PageServerFlags server;
  int threads = 0;
};

PageDisplay panel_to_play_on(const std::string& display, const ViewFilterFlags& filter) {
  if (display.empty())
    throw usage_error("--display", "is required",
                      "the display's calibration .json (visual.json), a name (see: lippmann displays), or a .toml");
  PageDisplay panel{load_display(display), filter.read()};
  require_own_frame(panel.display);
  return panel;
}

int play_scene(const PlayOptions& options, const Context& context) {
  SceneToSetUpFlags flags = options.scene;
  if (!options.display.empty()) flags.params.values["display"] = {options.display};
  const RenderParams params = scene_params(options.in, flags, options.field, options.threads);
  const PageDisplay panel = panel_to_play_on(params.optics.display, options.filter);
  auto scene = std::make_unique<LiveScene>(params, job_file_for(flags, params), context.warn, panel.interlace);
  scene->require_playable();
  return serve_page(std::make_unique<LiveAnswers>(std::move(scene), true), options.server, context);
}

int play_light_field(const PlayOptions& options, const Context& context) {
  refuse_scene_flags(options.in, options.scene);
  PageDisplay panel = panel_to_play_on(options.display, options.filter);
  std::vector<std::unique_ptr<PageField>> fields;
  LightFieldHints hints = options.field.read();
  hints.display = panel.display, hints.is_other_display = true;
  fields.push_back(std::make_unique<PageField>(options.in, std::move(hints), context));
  require_one_row(fields.front()->facts());
  return serve_page(std::move(fields), std::move(panel), options.server, context);
}

int run(const PlayOptions& options, Context& context) {
  context.threads = options.threads;
  return is_scene_to_set_up(options.in) ? play_scene(options, context) : play_light_field(options, context);
}

}  // namespace

void add_play_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<PlayOptions>();
  const Command command = root.add_command(
      "play",
      "Play a light field on a calibrated panel, full screen in the browser, interlaced as it plays; or set up a scene on it");
  command.footer("Open the page on the panel's screen and press F; see docs/guide/view.md.");
  command
      .add_option(
          "IN", options->in,
          "A quilt, a folder of views or frames, or any light field that `lippmann convert` reads; or a scene or a job, as "
          "`lippmann render` takes them")
      .required();
  command
      .add_option(
          "--display", options->display,
          "The panel: its calibration .json (visual.json), a name (see: lippmann displays), or a .toml of your own; default: "
          "the display of the job")
      .type_name("NAME|FILE");
  add_view_filter_flags(command, options->filter, "");
  add_page_server_flags(command, options->server);
  add_light_field_flags(command, options->field);
  command.add_option("--report", options->field.report, "Path of report.json, if it is not beside the pictures")
      .type_name("FILE");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  add_scene_to_set_up_flags(command, options->scene,
                            {"display", "views", "quilt", "view-angle", "cone-ends", "threads", "resume", "also", "page"});
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
