// The command that the settings of a report stand for, to be read and to be run again.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// One line for a shell. `settings`: as settings_json() makes them; what is as by default is left out, and so is `resume`,
/// which says nothing of the pictures. Settings that this version does not know are taken for flags of their name.
std::string command_of_settings(const std::string& scene, const nlohmann::ordered_json& settings);

/// The words that say one setting: a flag and its value, or several times both. Empty: it is as by default.
std::string flags_of_setting(const std::string& name, const nlohmann::ordered_json& value);

}  // namespace lippmann
