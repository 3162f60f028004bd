#include "lippmann/core/version.hpp"

namespace lippmann {

const char* version() { return LIPPMANN_VERSION_STRING; }

}  // namespace lippmann
