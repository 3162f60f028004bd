// The lines of `lippmann --version` below the version: commit, compiler, libraries and modules.
#pragma once

#include <string>

namespace lippmann::app {

/// Returns the lines, without a final newline. Loads no module.
std::string build_facts();

}  // namespace lippmann::app
