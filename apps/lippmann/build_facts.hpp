// What `lippmann --version` says of the build below the version: the commit, the compiler, the libraries, the modules.
#pragma once

#include <string>

namespace lippmann::app {

/// Lines without a newline at the end. No module is loaded for it.
std::string build_facts();

}  // namespace lippmann::app
