// Reconstructs the command line from the settings of a report, for people to read and run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// Returns one line for a shell. settings: as made by settings_json(). Omits defaults, and `resume`, because it does not affect
/// the pictures. An unknown setting becomes a flag with the setting's name.
std::string command_of_settings(const std::string& scene, const nlohmann::ordered_json& settings);

/// Returns the words for one setting: its flag, with the value if it takes one; for a list, one flag per value. Empty for a
/// default.
std::string flags_of_setting(const std::string& name, const nlohmann::ordered_json& value);

}  // namespace lippmann
