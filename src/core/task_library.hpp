// The version of oneTBB.
#pragma once

#include <string>

namespace lippmann {

/// Returns the version of the oneTBB library that is loaded, such as "2021.8.0". It may be newer than the version used for the
/// build.
std::string task_library_version();

}  // namespace lippmann
