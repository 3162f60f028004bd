// Sorts the pixels of a film into views: grids of pixels whose rays have about the same direction.
//
// A ray is at x(z) = l + s z, and V is the viewing distance. All rays of a view have the same k = l / V + s. The view shows a
// point (X, z) at (X - k z) / (1 - z / V) in the plane z = 0 (optics/view_place.hpp). Lengths are in mm in the display frame,
// with y up.
//
// The views of a quilt are its tiles. With lenses, a view has one pixel below each lens. It is the same pixel if lenses cover
// whole pixels; otherwise it is the pixel whose ray is nearest to the view's direction, to within half a pixel. Lenses at the
// panel's edge, hexagonal lenses and lenses of a fractional width leave gaps in the grid. The pixels of a slanted panel are its
// sub-pixels. All other optics, and lenses narrower than a pixel, have a single view, the film.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells;

/// Rows `first` to `end` - 1 of a film.
struct RowRange {
  int first, end;
};

class SortedViews {
 public:
  static constexpr std::uint32_t kNoPixel = 0xffffffff;

  /// `rows` are the rows of the film that a frame holds; pixel indices count from the first pixel of these rows. The views are
  /// those of the whole film, without the rows that have no pixel in the frame. `optics` must pass validate().
  SortedViews(const Optics& optics, RowRange rows);

  /// Returns the width and height of a view.
  Vec2i size() const { return size_; }
  /// Returns the columns and rows of views; the view in a column and row has the index row * columns + column.
  const ViewGrid& grid() const { return grid_; }
  int views() const { return grid_.count(); }

  /// Returns the pixel indices in row y of a view, one per column; kNoPixel marks a gap.
  const std::uint32_t* row(int view, int y) const { return pixels_.data() + slot(view, y); }

  /// Maps a place in the plane z = 0 to a pixel of the view: column = samples_per_mm.x place.x - first.x - shifts()[row], and
  /// row = first.y - samples_per_mm.y place.y - first_row(). The mapping is accurate to half a pixel's direction if lenses do
  /// not cover whole pixels, and exact otherwise.
  struct Sight {
    Vec2f k{0.0f}, first{0.0f};
  };
  const Sight& sight(int view) const { return sights_[static_cast<std::size_t>(view)]; }
  /// Returns the offset of each row's first lens, in columns. Valid indices are -kBeyond to size().y + kBeyond - 1.
  const float* shifts() const { return shifts_.data() + kBeyond; }
  static constexpr int kBeyond = 2;
  int first_row() const { return first_row_; }  ///< row 0 of these views, as a row in the views of the whole film
  float vergence() const { return vergence_; }  ///< 1 / V, per mm
  Vec2f samples_per_mm() const { return samples_per_mm_; }

  /// Returns the distance between neighbouring samples of a view in the plane z = 0, on the axis on which it is larger.
  float sample_distance_mm() const { return std::max(1.0f / samples_per_mm_.x, 1.0f / samples_per_mm_.y); }

 private:
  void sort_by_tiles(const Optics& optics, RowRange rows);
  void sort_by_lenses(const Optics& optics, const LensCells& cells, RowRange rows);
  /// Finds the view nearest to column at.x in row at.y of the grid that has no pixel at (x, y) yet. Returns -1 if there is
  /// none.
  int free_view(Vec2i at, int x, int y) const;
  std::size_t slot(int view, int y) const {
    return (static_cast<std::size_t>(view) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(size_.x);
  }

  Vec2i size_{0};
  int first_row_ = 0;
  ViewGrid grid_;
  std::vector<std::uint32_t> pixels_;
  std::vector<Sight> sights_;
  std::vector<float> shifts_;
  float vergence_ = 0.0f;
  Vec2f samples_per_mm_{1.0f};
};

}  // namespace lippmann
