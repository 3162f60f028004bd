// Reconstructs the command line from the settings of a report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// Returns one line for a shell. `settings` comes from settings_json(). Defaults and `resume` are left out. An unknown
/// setting becomes a flag with the setting's name.
std::string command_of_settings(const std::string& scene, const nlohmann::ordered_json& settings);

/// A list gives one flag per value. Returns an empty string for a default value.
std::string flags_of_setting(const std::string& name, const nlohmann::ordered_json& value);

}  // namespace lippmann
