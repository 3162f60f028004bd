#pragma once

namespace lippmann {

/// Returns the version of Embree that the program was built with, such as "3.13.5".
const char* embree_version();

}  // namespace lippmann
