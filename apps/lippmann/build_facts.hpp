// The lines of `lippmann --version` below the version: commit, compiler, libraries and optional modules.
#pragma once

#include <string>

namespace lippmann::app {

std::string build_facts();

}  // namespace lippmann::app
