// Which oneTBB the program runs on.
#pragma once

#include <string>

namespace lippmann {

/// As in "2021.8.0": of the library that is loaded, which may be newer than the one that the program was built with.
std::string task_library_version();

}  // namespace lippmann
