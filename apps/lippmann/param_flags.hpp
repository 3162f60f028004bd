// Flags of a command that are parameters of a render: declared from the table, read over a job file.
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

/// Filled while the command line is parsed; lives as long as the command.
struct ParamFlags {
  std::string scene;  ///< positional: a built-in name, a file, or a job
  std::string job;
  SheetFlags sheet;                                             ///< in place of `display`
  std::map<std::string_view, std::vector<std::string>> values;  ///< by parameter, as given

  /// The job file, if there is one, and what the flags say over it. Throws Error, also for a flag that has no effect.
  RenderParams read() const;
  /// The same, with all defaults filled in.
  ResolvedJob resolve() const;
};

/// Declares all parameters but the scene and those that are named: commands whose first argument may be something else than a
/// scene have flags of their own for these.
void add_param_flags_beside(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> unwanted);

/// Declares SCENE, --job, and the parameters that are listed by name or by group (all if none is).
void add_param_flags(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> wanted = {});

}  // namespace lippmann::app
