// The version of oneTBB.
#pragma once

#include <string>

namespace lippmann {

/// Returns the version of the loaded library, such as "2021.8.0". It may be newer than that of the build.
std::string task_library_version();

}  // namespace lippmann
