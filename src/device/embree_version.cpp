#include "device/embree_version.hpp"

#include <embree3/rtcore.h>

namespace lippmann {

const char* embree_version() { return RTC_VERSION_STRING; }

}  // namespace lippmann
