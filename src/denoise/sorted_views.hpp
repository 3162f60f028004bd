// Sorts the pixels of a film into views. A view is a grid of pixels whose rays have about the same direction.
//
// A ray is x(z) = l + s z, and V is the viewing distance. All rays of a view have the same k = l / V + s. The view shows a
// point (X, z) at (X - k z) / (1 - z / V) in the plane z = 0 (optics/view_place.hpp). Lengths are in mm in the display frame,
// with y up.
//
// The views of a quilt are its tiles. Optics with lenses have views with one pixel below each lens. If lenses cover a whole
// number of pixels, a view has the same pixel below every lens. Otherwise it has, below each lens, the pixel whose direction is
// nearest to the view's direction. The directions differ by at most half a pixel. The grid of a view has gaps at the panel's
// edge, for hexagonal lenses, and for lenses of a fractional width. All other optics have a single view, which is the film.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells;

struct RowRange {
  int first, end;
};

class SortedViews {
 public:
  static constexpr std::uint32_t kNoPixel = 0xffffffff;

  /// `rows` are the rows of the film that a frame holds. Pixel indices count from the first pixel of these rows. A view always
  /// has all its columns, but only the rows with a pixel in the frame.
  SortedViews(const Optics& optics, RowRange rows);

  Vec2i size() const { return size_; }
  const ViewGrid& grid() const { return grid_; }
  int views() const { return grid_.count(); }

  /// Returns the pixel indices in row y of a view, one per column. kNoPixel marks a gap.
  const std::uint32_t* row(int view, int y) const { return pixels_.data() + slot(view, y); }

  /// How a view maps points to pixels. k is the direction of the view's rays (see the top of this file). A position `place` in
  /// the plane z = 0 belongs to column samples_per_mm.x * place.x - first.x - shifts()[row], and to row first.y -
  /// samples_per_mm.y * place.y - first_row(). If lenses do not cover a whole number of pixels, the direction of a ray may
  /// differ from k by half a pixel.
  struct Sight {
    Vec2f k{0.0f}, first{0.0f};
  };
  const Sight& sight(int view) const { return sights_[static_cast<std::size_t>(view)]; }
  /// Returns the offset of the first lens of each row, in columns. Valid indices are -kBeyond to size().y + kBeyond - 1.
  const float* shifts() const { return shifts_.data() + kBeyond; }
  static constexpr int kBeyond = 2;
  int first_row() const { return first_row_; }
  float vergence() const { return vergence_; }
  Vec2f samples_per_mm() const { return samples_per_mm_; }

  /// Returns the distance between neighbouring samples of a view in the plane z = 0, in mm: the larger of the distances along x
  /// and y.
  float sample_distance_mm() const { return std::max(1.0f / samples_per_mm_.x, 1.0f / samples_per_mm_.y); }

 private:
  void sort_by_tiles(const Optics& optics, RowRange rows);
  void sort_by_lenses(const Optics& optics, const LensCells& cells, RowRange rows);
  /// Searches row at.y of the grid of views for views that have no pixel at (x, y) yet. Returns the one nearest to column at.x,
  /// or -1.
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
