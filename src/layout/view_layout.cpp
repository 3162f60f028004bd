#include "lippmann/layout/view_layout.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// `at`: position of a view's top left pixel. `step`: distance from a pixel of the view to the next pixel, across and down.
struct Corner {
  Vec2i at, step;
};

Corner corner_of_view(const ViewLayout& layout, Vec2i size, Vec2i picture, int view) {
  switch (layout.kind) {
    case LayoutKind::kIntegral: {
      const ViewGrid& grid = layout.grid;
      return {{grid.columns - 1 - view % grid.columns, view / grid.columns}, {grid.columns, grid.rows}};
    }
    case LayoutKind::kEslf: {
      const ViewGrid& grid = layout.grid;
      return {{view % grid.columns, grid.rows - 1 - view / grid.columns}, {grid.columns, grid.rows}};
    }
    case LayoutKind::kQuilt: {
      const int column = view % layout.tiles.columns, row = view / layout.tiles.columns;
      return {{column * size.x, picture.y - (row + 1) * size.y}, {1, 1}};
    }
    case LayoutKind::kStack:
      break;
  }
  return {{0, view * size.y}, {1, 1}};
}

}  // namespace

Vec2i picture_size(const ViewLayout& layout, Vec2i size) {
  switch (layout.kind) {
    case LayoutKind::kIntegral:
    case LayoutKind::kEslf:
      return {size.x * layout.grid.columns, size.y * layout.grid.rows};
    case LayoutKind::kQuilt:
      return {size.x * layout.tiles.columns, size.y * layout.tiles.rows};
    case LayoutKind::kStack:
      break;
  }
  return {size.x, size.y * layout.grid.count()};
}

Vec2i view_size(const ViewLayout& layout, Vec2i picture, const std::string& where) {
  const Vec2i parts = picture_size(layout, {1, 1});
  const Vec2i size = picture / parts;
  const bool fills = size * parts == picture || layout.kind == LayoutKind::kQuilt;
  if (size.x > 0 && size.y > 0 && fills) return size;
  const char* what =
      layout.kind == LayoutKind::kIntegral || layout.kind == LayoutKind::kEslf ? "pixels below each lens" : "views";
  throw Error(where, fmt::format("{}x{} pixels cannot be divided into {}x{} {}", picture.x, picture.y, parts.x, parts.y, what),
              "the number of `views` or `quilt` tiles of the picture");
}

ViewPlace place_of_view(const ViewLayout& layout, Vec2i size, Vec2i picture, int view) {
  const Corner corner = corner_of_view(layout, size, picture, view);
  const std::ptrdiff_t row = picture.x;
  return {corner.at.y * row + corner.at.x, corner.step.x, corner.step.y * row};
}

ViewGrid squarest_tiles(int views) {
  int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(views))));
  while (views % columns != 0) ++columns;
  return {columns, views / columns};
}

std::vector<std::uint32_t> pixels_of_views(const ViewLayout& layout, Vec2i size, Vec2i picture) {
  std::vector<std::uint32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                 static_cast<std::size_t>(layout.grid.count()));
  for (int view = 0; view < layout.grid.count(); ++view) {
    const ViewPlace place = place_of_view(layout, size, picture, view);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        pixels.push_back(static_cast<std::uint32_t>(place.first + x * place.across + y * place.down));
  }
  return pixels;
}

}  // namespace lippmann
