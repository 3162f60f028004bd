// Modules: shared objects next to the program. They contain the parts that need libraries which most commands do not need, and
// are loaded on first use.
#pragma once

#include <string>

namespace lippmann {

struct ModuleName {
  const char* file;  ///< for example liblippmann_video.so
  /// Its only exported function: const void* entry(int version). It returns null if it does not support the version.
  const char* entry;
  const char* purpose;  ///< what needs the module, for messages; for example "videos"
  const char* package;  ///< the package that installs it
};

/// Calls the module's entry function with `version` and returns its result. The module is never unloaded, because its libraries
/// do not support that. Throws Error that names the module and what is missing: the module itself or a library.
const void* load_module(const ModuleName& module, int version);

/// Returns whether the module's file exists.
bool is_module_installed(const ModuleName& module);

}  // namespace lippmann
