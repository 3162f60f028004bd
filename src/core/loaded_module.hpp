// Modules: shared objects next to the program with parts that need libraries most commands do not need. They are loaded on
// first use.
#pragma once

#include <string>

namespace lippmann {

struct ModuleName {
  const char* file;     ///< for example liblippmann_video.so
  const char* entry;    ///< its only exported function: const void* entry(int version); returns null for another version
  const char* purpose;  ///< for messages, for example "videos"
  const char* package;  ///< the package that installs it
};

/// Returns the result of the module's entry function for a version. The module is never unloaded, because its libraries do not
/// support that. Throws Error that names the module and the missing part: the module itself or a library.
const void* load_module(const ModuleName& module, int version);

/// Returns whether the module's file exists.
bool is_module_installed(const ModuleName& module);

}  // namespace lippmann
