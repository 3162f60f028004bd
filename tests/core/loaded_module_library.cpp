// A shared library with its own copy of load_module, like the Python module.
#include "core/loaded_module.hpp"

extern "C" bool is_installed_for_library(const char* file) {
  return lippmann::is_module_installed({file, "entry", "tests", "no package"});
}
