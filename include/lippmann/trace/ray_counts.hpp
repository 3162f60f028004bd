#pragma once

#include <cstdint>

namespace lippmann {

struct RayCounts {
  std::uint64_t primary = 0, shadow = 0, reflection = 0, indirect = 0;  ///< reflection counts mirrored and refracted rays
  std::uint64_t total() const { return primary + shadow + reflection + indirect; }
};

inline void add(const RayCounts& more, RayCounts& counts) {
  counts.primary += more.primary, counts.shadow += more.shadow;
  counts.reflection += more.reflection, counts.indirect += more.indirect;
}

}  // namespace lippmann
