#include "replay/rotate_elemental.hpp"

#include <optional>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

int mirrored_in_block(int pixel, int size) {
  const int block = pixel / size * size;
  return block + size - 1 - (pixel - block);
}

PixelMap map_of(const Panel& panel, const auto& source_of) {
  PixelMap map{panel.width, panel.height, {}};
  map.source.reserve(static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height));
  for (int y = 0; y < panel.height; ++y)
    for (int x = 0; x < panel.width; ++x) {
      const Vec2i from = source_of(x, y);
      const bool inside = from.x >= 0 && from.y >= 0 && from.x < panel.width && from.y < panel.height;
      map.source.push_back(inside ? static_cast<std::uint32_t>(from.y) * static_cast<std::uint32_t>(panel.width) +
                                        static_cast<std::uint32_t>(from.x)
                                  : kNoPixel);
    }
  return map;
}

/// Exchanges tile v with tile N - 1 - v of a quilt with N tiles. Padding stays.
PixelMap reversed_views(const Panel& panel, const ViewTiles& views) {
  const int width = panel.width / views.columns, height = panel.height / views.rows;
  const int padding = panel.height - height * views.rows;
  return map_of(panel, [&](int x, int y) {
    if (x >= width * views.columns || y < padding) return Vec2i(x, y);
    const Vec2i tile(x / width, (y - padding) / height);
    return Vec2i(x + (views.columns - 1 - 2 * tile.x) * width, y + (views.rows - 1 - 2 * tile.y) * height);
  });
}

}  // namespace

PixelMap rotated_elemental_images(const Optics& optics, const std::string& where) {
  if (const std::optional<ViewTiles> views = view_tiles(optics)) return reversed_views(optics.panel, *views);
  const Vec2i pixels = whole_pixels_per_lens(optics);
  if (pixels.x < 1)
    throw Error(where, "rotating elemental images needs a whole number of pixels per lens",
                "a picture of such an array, or `spoc`, which works with any array");
  return map_of(optics.panel,
                [&](int x, int y) { return Vec2i(mirrored_in_block(x, pixels.x), mirrored_in_block(y, pixels.y)); });
}

}  // namespace lippmann
