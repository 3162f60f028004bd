// `lippmann check DIR`: whether a rendered folder's files are still those that were written.
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "render/finished_frames.hpp"

namespace lippmann::app {
namespace {

struct Options {
  std::string folder;
  bool json = false;
};

void print_text(const std::string& folder, const FolderCheck& check) {
  for (const std::string& name : check.damaged) fmt::print("damaged  {}\n", name);
  for (const std::string& name : check.missing) fmt::print("missing  {}\n", name);
  for (const std::string& name : check.foreign) fmt::print("foreign  {}\n", name);
  fmt::print("{}: {} files of {} frames, {} damaged, {} missing; {} foreign\n", folder, check.files, check.frames,
             check.damaged.size(), check.missing.size(), check.foreign.size());
}

int run(const Options& options) {
  const FolderCheck check = check_folder(options.folder);
  if (options.json)
    print_json({{"folder", options.folder},
                {"frames", check.frames},
                {"files", check.files},
                {"damaged", check.damaged},
                {"missing", check.missing},
                {"foreign", check.foreign},
                {"passed", check.passed()}});
  else
    print_text(options.folder, check);
  return check.passed() ? 0 : 1;
}

}  // namespace

void add_check_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  const Command command = root.add_command("check", "Find files of a rendered folder that are damaged, missing or foreign");
  command.add_option("DIR", options->folder, "The folder that a render wrote to").required();
  command.add_flag("--json", options->json, "Print JSON on stdout");
  command.footer(
      "Exit code 1 where anything is damaged, missing or foreign. 'lippmann render DIR/job.toml --resume' makes damaged and\n"
      "missing frames again.\n");
  command.when_named([options, &chosen] { chosen = [options](Context&) { return run(*options); }; });
}

}  // namespace lippmann::app
