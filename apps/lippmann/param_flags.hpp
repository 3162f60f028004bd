// Flags that set the parameters of a render. They are declared from the table of parameters, and override the job file.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/lippmann/sheet_flags.hpp"
#include "job/resolved_job.hpp"

namespace lippmann::app {

class Command;  // declared in command_line.hpp

/// The flags of a command. This object must live as long as the command, because parsing the command line writes the values.
struct ParamFlags {
  std::string scene;  ///< positional argument: a built-in name, a file, or a job
  std::string job;
  SheetFlags sheet;                                             ///< describes a sheet; replaces the parameter `display`
  std::map<std::string_view, std::vector<std::string>> values;  ///< values as given, by parameter

  /// Returns the parameters of the job file, if one is given, overridden by the flags. Throws Error for unreadable values and
  /// for a flag without effect.
  RenderParams read() const;
  /// Returns the parameters as a job with all defaults filled in.
  ResolvedJob resolve() const;
};

/// Declares all parameters except the scene and `unwanted`. Commands whose first argument may be something other than a scene
/// call this, and declare the left-out parameters themselves.
void add_param_flags_beside(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> unwanted);

/// Declares SCENE, --job, and the parameters whose names or groups are in `wanted` (empty: all).
void add_param_flags(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> wanted = {});

}  // namespace lippmann::app
