// The lines of `lippmann --version` below the version: commit, compiler, libraries and optional modules.
#pragma once

#include <string>

namespace lippmann::app {

/// Returns the lines, without a final newline.
std::string build_facts();

}  // namespace lippmann::app
