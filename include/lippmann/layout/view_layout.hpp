// Positions of the pixels of a light field's views in pictures that hold all views at once.
//
// Views form a grid: view v = row * columns + column. Column 0 is seen by the leftmost eye, row 0 by the lowest. All views have
// the same size.
//
//   integral  for a lens array with columns x rows pixels below each lens; pixel (x, y) of every view lies below lens (x, y).
//             Lenses invert: the pixel below a lens for the leftmost view is the rightmost, for the lowest view the topmost.
//   quilt     views side by side: view 0 at the bottom left, then to the right, then upwards; the last at the top right
//             (Looking Glass).
//   eslf      (plenoptic cameras, Lytro) like integral without the inversion: the view from the left is the leftmost pixel,
//             the view from above the topmost.
//   stack     views stacked vertically, view 0 on top, in storage order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ViewGrid {
  int columns = 8, rows = 1;
  int count() const { return columns * rows; }
  bool operator==(const ViewGrid&) const = default;
};

enum class LayoutKind { kIntegral, kQuilt, kStack, kEslf };

struct ViewLayout {
  LayoutKind kind = LayoutKind::kStack;
  ViewGrid grid{};
  ViewGrid tiles{};  ///< columns and rows of a quilt's tiles; their product is the number of views
};

/// Size of the whole picture for views of `view_size`.
Vec2i picture_size(const ViewLayout& layout, Vec2i view_size);

/// Size of one view. Throws Error naming `where` if the views do not fill the picture. Quilts may have padding at the right and
/// at the top.
Vec2i view_size(const ViewLayout& layout, Vec2i picture, const std::string& where);

/// Pixel (x, y) of a view has the row-major index first + x * across + y * down in the picture.
struct ViewPlace {
  std::ptrdiff_t first = 0, across = 0, down = 0;
};

ViewPlace place_of_view(const ViewLayout& layout, Vec2i view_size, Vec2i picture, int view);

/// Returns the columns and rows that are closest to a square, with at least as many columns as rows: 8 x 6 for 48 views.
ViewGrid squarest_tiles(int views);

/// Returns, for each pixel of the vertically stacked views, the row-major index of the same pixel in the picture.
std::vector<std::uint32_t> pixels_of_views(const ViewLayout& layout, Vec2i view_size, Vec2i picture);

}  // namespace lippmann
