#include "layout/film_layout.hpp"

#include <optional>
#include <variant>

#include "lippmann/core/error.hpp"

namespace lippmann {

ViewLayout film_layout(const Optics& optics, const char* where) {
  if (const std::optional<ViewTiles> views = view_tiles(optics)) {
    const ViewGrid tiles{views->columns, views->rows};
    return {LayoutKind::kQuilt, views->camera_grid ? tiles : ViewGrid{tiles.count(), 1}, tiles};
  }
  const Vec2i n = whole_pixels_per_lens(optics);
  if (n.x > 0) return {LayoutKind::kIntegral, {n.x, n.y}, {}};
  if (std::holds_alternative<PlenopticCamera>(optics.model))
    throw usage_error(where, "the views of a plenoptic camera are computed from its finished raw pictures, after the render",
                      "no `layout` and `to` now; 'lippmann convert DIR OUT' with `to` after the render");
  throw usage_error(where, "lenses without a whole number of pixels have no views",
                    "a whole number of pixels below every lens, without slant or hexagonal packing");
}

}  // namespace lippmann
