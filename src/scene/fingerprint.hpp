// Computes a hash of everything in a scene that affects its pictures. Names do not affect the hash.
#pragma once

#include <cstdint>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

std::uint64_t fingerprint(const Scene& scene);

}  // namespace lippmann
