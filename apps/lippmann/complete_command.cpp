// `lippmann complete -- WORD...`: prints completions of the last word, for shells (data/completions).
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "job/params_table.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann::app {
namespace {

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const LightFieldFormat& format : light_field_formats()) names.emplace_back(format.name);
  return names;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names{"test-pattern"};
  for (const BuiltinScene& scene : builtin_scenes()) names.emplace_back(scene.name);
  return names;
}

std::vector<std::string> display_names() {
  std::vector<std::string> names;
  for (const Display& display : display_presets()) names.push_back(display.name);
  return names;
}

std::vector<std::string> values_of(const std::string& name) {
  if (name == "KIND") return {"pitch", "phase", "viewing-zone", "lens"};
  if (name == "SCENE") return scene_names();
  if (name == "display") return display_names();
  if (name == "from") return format_names();
  if (name == "to") return {output_format_names().begin(), output_format_names().end()};
  const ParamInfo* param = find_param(name);
  return param ? std::vector<std::string>(param->choices.begin(), param->choices.end()) : std::vector<std::string>();
}

int run(const CommandLine& command_line, const std::vector<std::string>& words) {
  for (const std::string& line : command_line.completions(words, values_of)) fmt::print("{}\n", line);
  return 0;
}

}  // namespace

void add_complete_command(const Command& root, Action& chosen, const CommandLine& command_line) {
  auto words = std::make_shared<std::vector<std::string>>();
  const Command command = root.add_command("complete", "Print completions of the last word, for shells");
  command.hide();
  command.add_option("WORD", *words, "The words after `lippmann`; the last may be empty");
  command.when_named(
      [words, &chosen, &command_line] { chosen = [words, &command_line](Context&) { return run(command_line, *words); }; });
}

}  // namespace lippmann::app
