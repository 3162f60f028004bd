// Flags of a command that set parameters of a render. They are declared from the table and override the job file.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/lippmann/sheet_flags.hpp"
#include "job/resolved_job.hpp"

namespace lippmann::app {

class Command;  // command_line.hpp

/// The values are written while the command line is parsed. Must live as long as the command.
struct ParamFlags {
  std::string scene;  ///< positional: a built-in name, a file, or a job
  std::string job;
  SheetFlags sheet;                                             ///< replaces `display`
  std::map<std::string_view, std::vector<std::string>> values;  ///< values as given, by parameter

  /// Returns the job file's parameters, if there is one, overridden by the flags. Throws Error, also for a flag without effect.
  RenderParams read() const;
  /// Returns the same with all defaults filled in.
  ResolvedJob resolve() const;
};

/// Declares all parameters but the scene and `unwanted`: a command whose first argument may be something other than a scene
/// declares these itself.
void add_param_flags_beside(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> unwanted);

/// Declares SCENE, --job, and the parameters whose names or groups are in `wanted` (empty: all).
void add_param_flags(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> wanted = {});

}  // namespace lippmann::app
