// `lippmann scenes`: lists the built-in scenes.
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "lippmann/scene/builtin.hpp"

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
  if (json) print_json(rows);
  return 0;
}

}  // namespace

void add_scenes_command(const Command& root, Action& chosen) {
  auto json = std::make_shared<bool>(false);
  const Command command = root.add_command("scenes", "List the built-in scenes");
  command.add_flag("--json", *json, "Print JSON on stdout");
  command.when_named([json, &chosen] { chosen = [json](Context&) { return run(*json); }; });
}

}  // namespace lippmann::app
