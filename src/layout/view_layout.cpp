#include "layout/view_layout.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace lippmann {
namespace {

/// Where pixel (x, y) of a view is in the picture.
Vec2i place(const ViewLayout& layout, Vec2i size, Vec2i picture, int view, int x, int y) {
  switch (layout.kind) {
    case LayoutKind::kIntegral: {
      const ViewGrid& grid = layout.grid;
      const int column = view % grid.columns, row = view / grid.columns;
      return {x * grid.columns + (grid.columns - 1 - column), y * grid.rows + row};
    }
    case LayoutKind::kEslf: {
      const ViewGrid& grid = layout.grid;
      return {x * grid.columns + view % grid.columns, y * grid.rows + (grid.rows - 1 - view / grid.columns)};
    }
    case LayoutKind::kQuilt: {
      const int column = view % layout.tiles.columns, row = view / layout.tiles.columns;
      return {column * size.x + x, picture.y - (row + 1) * size.y + y};
    }
    case LayoutKind::kStack:
      break;
  }
  return {x, view * size.y + y};
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
              "--views or --quilt as the picture was made");
}

std::vector<std::uint32_t> pixels_of_views(const ViewLayout& layout, Vec2i size, Vec2i picture) {
  std::vector<std::uint32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                 static_cast<std::size_t>(layout.grid.count()));
  for (int view = 0; view < layout.grid.count(); ++view)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const Vec2i at = place(layout, size, picture, view, x, y);
        pixels.push_back(static_cast<std::uint32_t>(at.y) * static_cast<std::uint32_t>(picture.x) +
                         static_cast<std::uint32_t>(at.x));
      }
  return pixels;
}

}  // namespace lippmann
