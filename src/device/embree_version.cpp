#include "device/embree_version.hpp"

#include "device/embree_shim.hpp"

namespace lippmann {

const char* embree_version() { return RTC_VERSION_STRING; }

}  // namespace lippmann
