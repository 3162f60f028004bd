// `lippmann play IN --display CAL`: a light field on a calibrated panel, interlaced by the page in the browser.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/page_server.hpp"
#include "apps/lippmann/view_filter_flags.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/layout/interlace.hpp"

namespace lippmann::app {
namespace {

struct PlayOptions {
  std::string in, display;
  ViewFilterFlags filter;
  LightFieldFlags field;
  PageServerFlags server;
  int threads = 0;
};

int run(const PlayOptions& options, Context& context) {
  context.threads = options.threads;
  PageDisplay display{load_display(options.display), options.filter.read()};
  require_own_frame(display.display);
  std::vector<std::unique_ptr<PageField>> fields;
  fields.push_back(std::make_unique<PageField>(options.in, options.field.read(), context));
  require_one_row(fields.front()->facts());
  return serve_page(std::move(fields), std::move(display), options.server, context);
}

}  // namespace

void add_play_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<PlayOptions>();
  const Command command =
      root.add_command("play", "Play a light field on a calibrated panel, full screen in the browser, interlaced as it plays");
  command.footer("Open the page on the panel's screen and press F; see docs/view.md.");
  command
      .add_option("IN", options->in, "A quilt, a folder of views or frames, or any light field that `lippmann convert` reads")
      .required();
  command
      .add_option("--display", options->display,
                  "The panel: its calibration .json (visual.json), a name (see: lippmann displays), or a .toml of your own")
      .required();
  add_view_filter_flags(command, options->filter, "");
  add_page_server_flags(command, options->server);
  add_light_field_flags(command, options->field);
  command.add_option("--report", options->field.report, "Path of report.json, if it is not beside the pictures")
      .type_name("FILE");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
