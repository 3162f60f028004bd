#pragma once

namespace lippmann {

const char* embree_version();

}  // namespace lippmann
