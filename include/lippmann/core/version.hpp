// The version of Lippmann. CMake reads the three numbers from this file; scripts/release checks all copies of them.
#pragma once

#define LIPPMANN_VERSION_MAJOR 0
#define LIPPMANN_VERSION_MINOR 3
#define LIPPMANN_VERSION_PATCH 0

/// One number to compare in `#if`: 10203 is version 1.2.3.
#define LIPPMANN_VERSION (LIPPMANN_VERSION_MAJOR * 10000 + LIPPMANN_VERSION_MINOR * 100 + LIPPMANN_VERSION_PATCH)

namespace lippmann {

/// The version of the library that runs, such as "0.3.0"; the macros give that of the headers. Job files, reports and EXR files
/// contain it.
const char* version();

}  // namespace lippmann
