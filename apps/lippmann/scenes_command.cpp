// `lippmann scenes`: the built-in scenes.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/lippmann/commands.hpp"
#include "scene/builtin.hpp"

namespace lippmann::app {
namespace {

int run(bool json) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (json)
      rows.push_back({{"name", scene.name}, {"description", scene.description}});
    else
      fmt::print("{:<12} {}\n", scene.name, scene.description);
  }
  if (json) fmt::print("{}\n", rows.dump(2));
  return 0;
}

}  // namespace

void add_scenes_command(CLI::App& root, Action& chosen) {
  auto json = std::make_shared<bool>(false);
  CLI::App& command = *root.add_subcommand("scenes", "List the built-in scenes");
  command.add_flag("--json", *json, "Print JSON on stdout");
  command.callback([json, &chosen] { chosen = [json](Context&) { return run(*json); }; });
}

}  // namespace lippmann::app
