// `lippmann view IN [OTHER]`: a light field, or two beside each other, in the browser.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/page_server.hpp"
#include "view/saved_page.hpp"

namespace lippmann::app {
namespace {

struct ViewOptions {
  std::string in, other, save;
  LightFieldFlags field;
  PageServerFlags server;
  int threads = 0;
};

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

int run(const ViewOptions& options, Context& context) {
  context.threads = options.threads;
  if (!options.save.empty()) return save(options, context);
  return serve_page(read_fields(options, context), std::nullopt, options.server, context);
}

}  // namespace

void add_view_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ViewOptions>();
  const Command command = root.add_command("view", "Show a light field in the browser: eyes, time, refocusing, comparison");
  command.footer("Nothing outside IN and OTHER is readable through the server; see docs/view.md.");
  command
      .add_option("IN", options->in, "A rendered picture, a folder of frames, or any light field that `lippmann convert` reads")
      .required();
  command.add_option("OTHER", options->other, "Another one, compared with it: wiped, side by side, or as a difference");
  add_page_server_flags(command, options->server);
  command
      .add_option("--save", options->save,
                  "Instead, write the page with all its data into a folder that any web server serves, or a disk")
      .type_name("FOLDER");
  add_light_field_flags(command, options->field);
  command.add_option("--report", options->field.report, "Path of report.json, if it is not beside the pictures")
      .type_name("FILE");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
