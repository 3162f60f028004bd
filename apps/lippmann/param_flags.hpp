// Flags that set the parameters of a render. They override the job file.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/lippmann/sheet_flags.hpp"
#include "job/resolved_job.hpp"

namespace lippmann::app {

class Command;

/// The flags of a command. Must outlive the command, because parsing the command line writes the values.
struct ParamFlags {
  std::string scene;  ///< positional argument: a built-in name, a file, or a job
  std::string job;
  SheetFlags sheet;  ///< describes a sheet; replaces the parameter `display`
  std::map<std::string_view, std::vector<std::string>> values;

  /// Returns the parameters of the job file, if any, overridden by the flags. Throws Error for unreadable values and for a flag
  /// without effect.
  RenderParams read() const;
  ResolvedJob resolve() const;
};

/// Declares all parameters except the scene and `unwanted`, for commands whose first argument need not be a scene.
void add_param_flags_beside(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> unwanted);

/// Declares SCENE, --job, and the parameters whose names or groups are in `wanted` (empty: all).
void add_param_flags(const Command& command, ParamFlags& flags, std::initializer_list<std::string_view> wanted = {});

}  // namespace lippmann::app
