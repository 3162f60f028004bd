#include "job/settings_command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "core/printable.hpp"
#include "job/params_table.hpp"
#include "job/settings_json.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

std::string setting_text(const Json& value) { return value.is_string() ? value.get<std::string>() : json_to_text(value, -1); }

bool is_default(const std::string& name, const Json& value) {
  static const Json defaults = settings_json(RenderParams{});
  return value.is_null() || (defaults.contains(name) && defaults[name] == value);
}

/// The name may come from an untrusted report.
std::string flag_of(const std::string& name) { return shell_word("--" + name); }

std::string switch_of(const std::string& name, bool is_on) {
  if (is_on) return flag_of(name);
  const ParamInfo* info = find_param(name);
  return info && !info->opposite.empty() ? flag_of(std::string(info->opposite)) : std::string();
}

}  // namespace

std::string flags_of_setting(const std::string& name, const Json& value) {
  if (is_default(name, value)) return {};
  if (value.is_boolean()) return switch_of(name, value.get<bool>());
  if (!value.is_array()) return fmt::format("{} {}", flag_of(name), shell_word(setting_text(value)));
  std::string words;
  for (const Json& one : value)
    words += fmt::format("{}{} {}", words.empty() ? "" : " ", flag_of(name), shell_word(setting_text(one)));
  return words;
}

std::string command_of_settings(const std::string& scene, const Json& settings) {
  std::string command = "lippmann render " + shell_word(scene);
  for (const auto& [name, value] : settings.items()) {
    const std::string words = name == "resume" ? std::string() : flags_of_setting(name, value);
    if (!words.empty()) command += ' ' + words;
  }
  return command;
}

}  // namespace lippmann
