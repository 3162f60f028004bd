// A number that tells scenes apart by everything that pictures of them depend on; names do not count.
#pragma once

#include <cstdint>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

std::uint64_t fingerprint(const Scene& scene);

}  // namespace lippmann
