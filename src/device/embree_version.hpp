// Which Embree the program was built with.
#pragma once

namespace lippmann {

/// As in "3.13.5".
const char* embree_version();

}  // namespace lippmann
