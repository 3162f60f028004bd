#include "lippmann/core/version.hpp"

#define LIPPMANN_QUOTE(x) #x
#define LIPPMANN_JOIN_VERSION(major, minor, patch) LIPPMANN_QUOTE(major) "." LIPPMANN_QUOTE(minor) "." LIPPMANN_QUOTE(patch)

namespace lippmann {

const char* version() { return LIPPMANN_JOIN_VERSION(LIPPMANN_VERSION_MAJOR, LIPPMANN_VERSION_MINOR, LIPPMANN_VERSION_PATCH); }

}  // namespace lippmann
