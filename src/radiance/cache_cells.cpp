#include "radiance/cache_cells.hpp"

#include <algorithm>

namespace lippmann {

float CacheCells::size(float path_length) const {
  const Vec2f widths = beam.widths(path_length);
  return samples_per_cell * std::max(std::min(widths.x, widths.y), 1e-20f);
}

}  // namespace lippmann
