// The version of Lippmann. CMake reads the three numbers from this file.
#pragma once

#define LIPPMANN_VERSION_MAJOR 0
#define LIPPMANN_VERSION_MINOR 3
#define LIPPMANN_VERSION_PATCH 0

#define LIPPMANN_VERSION (LIPPMANN_VERSION_MAJOR * 10000 + LIPPMANN_VERSION_MINOR * 100 + LIPPMANN_VERSION_PATCH)

#define LIPPMANN_VERSION_STRING LIPPMANN_VERSION_JOIN(LIPPMANN_VERSION_MAJOR, LIPPMANN_VERSION_MINOR, LIPPMANN_VERSION_PATCH)
#define LIPPMANN_VERSION_JOIN(major, minor, patch) \
  LIPPMANN_VERSION_QUOTE(major) "." LIPPMANN_VERSION_QUOTE(minor) "." LIPPMANN_VERSION_QUOTE(patch)
#define LIPPMANN_VERSION_QUOTE(number) #number

namespace lippmann {

/// Returns the version of the linked library, such as "0.3.0". The macros above are the version of the headers.
const char* version();

}  // namespace lippmann
