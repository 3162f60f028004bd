// Parts of the program that need libraries which most commands do not: modules, shared objects beside the program that are
// loaded when they are first asked for.
#pragma once

#include <string>

namespace lippmann {

struct ModuleName {
  const char* file;     ///< liblippmann_video.so
  const char* entry;    ///< the one function that it exports: const void* entry(int version); null for another version
  const char* purpose;  ///< "videos", for messages
  const char* package;  ///< that installs it
};

/// What the module's entry gives for that version. It stays loaded: libraries below it do not survive being unloaded. Throws
/// Error that names the module and what is missing: the module itself or a library that it needs.
const void* load_module(const ModuleName& module, int version);

/// Whether the module lies where it would be loaded from.
bool is_module_installed(const ModuleName& module);

}  // namespace lippmann
