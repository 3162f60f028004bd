// Where the pixels of a light field's views lie in the pictures that hold all of them at once.
//
// Views are a grid: view v = row * columns + column, column 0 seen from the leftmost eye, row 0 from the lowest. All have one
// size.
//
//   integral  what lies behind a lens array with columns x rows pixels below each lens; pixel (x, y) of every view lies below
//   lens (x, y).
//             A lens turns its pixels round: what is seen from the left is the rightmost of them, what is seen from below the
//             topmost.
//   quilt     views side by side: view 0 at the bottom left, then to the right, then upwards; the last at the top right
//             (Looking Glass).
//   eslf      (a plenoptic camera's picture, Lytro's) as integral, but not turned round: what is seen from the left is the
//             leftmost, what is seen from above the topmost.
//   stack     views one below the other, view 0 on top: as they are stored one by one.
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
  ViewGrid grid;   ///< how many views across and up
  ViewGrid tiles;  ///< a quilt's tiles side by side and above each other; as many as there are views
};

/// The size of the whole picture. view_size: that of one view.
Vec2i picture_size(const ViewLayout& layout, Vec2i view_size);

/// The size of one view in a picture of that size. Throws Error naming `where` if views do not fill the picture exactly, unless
/// it is a quilt: there tiles are floor(width / columns) x floor(height / rows) pixels, and what is left over at the right and
/// at the top is padding.
Vec2i view_size(const ViewLayout& layout, Vec2i picture, const std::string& where);

/// Where the pixels of one view lie: pixel (x, y) of it at `first` + x `across` + y `down`, row-major in the picture.
struct ViewPlace {
  std::ptrdiff_t first, across, down;
};

ViewPlace place_of_view(const ViewLayout& layout, Vec2i view_size, Vec2i picture, int view);

/// As many tiles as views, as square as can be, wider rather than higher: 8 x 6 for 48.
ViewGrid squarest_tiles(int views);

/// Entry i is the pixel (row-major index) of the picture that shows pixel i of the stack.
std::vector<std::uint32_t> pixels_of_views(const ViewLayout& layout, Vec2i view_size, Vec2i picture);

}  // namespace lippmann
