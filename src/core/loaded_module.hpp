#pragma once

#include <string>

namespace lippmann {

struct ModuleName {
  const char* file;
  /// Name of the only exported function, of type const void*(int version). It returns null if the module does not support the
  /// version.
  const char* entry;
  const char* purpose;  ///< what needs the module, for messages; for example "videos"
  const char* package;
};

/// Calls the module's entry function with `version` and returns the result. The module is never unloaded, because its libraries
/// do not support unloading. Throws Error if the module or one of its libraries is missing.
const void* load_module(const ModuleName& module, int version);

bool is_module_installed(const ModuleName& module);

}  // namespace lippmann
