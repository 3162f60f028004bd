// Reconstructs the command line from the settings of a report, for people to read and run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// Returns one line for a shell. settings: as made by settings_json(). Defaults are omitted, and `resume`, which does not
/// affect the pictures. Unknown settings become flags of their name.
std::string command_of_settings(const std::string& scene, const nlohmann::ordered_json& settings);

/// Returns the words for one setting: a flag and its value, or several of both. Empty for a default.
std::string flags_of_setting(const std::string& name, const nlohmann::ordered_json& value);

}  // namespace lippmann
