// The pixels of a film, sorted into views: grids of pixels that look in about the same direction.
//
// With x(z) = l + s z for a ray, k = l / V + s is the same for all rays of a view, and the view sees a point (X, z) at the
// place (X - k z) / (1 - z / V) of the plane z = 0 (optics/view_place.hpp). Display frame: mm, y up.
//
// Views of a quilt are its tiles. Of lenses, a view has one pixel below each: the same one where lenses cover whole pixels,
// else the one whose ray leaves in the direction nearest to the view's, to half a pixel. Lenses at the panel's edge, hexagons
// and lenses of a fractional width leave places without a pixel. A slanted panel's pixels are its sub-pixels. All other optics,
// and lenses narrower than a pixel, have a single view: the film.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells;

/// Rows of a film.
struct RowRange {
  int first, end;
};

class SortedViews {
 public:
  static constexpr std::uint32_t kNoPixel = 0xffffffff;

  /// rows: of the film, those that there are; pixels are counted from the first of them. Views are those of the whole film, but
  /// for rows that have no pixel.
  SortedViews(const Optics& optics, RowRange rows);

  /// Columns and rows of a view.
  Vec2i size() const { return size_; }
  /// Views across and up: view v = row * columns + column.
  const ViewGrid& grid() const { return grid_; }
  int views() const { return grid_.count(); }

  /// The film's pixels in row y of a view, or kNoPixel; as many as a view has columns.
  const std::uint32_t* row(int view, int y) const { return pixels_.data() + slot(view, y); }

  /// A view sees points at column = samples_per_mm.x place.x - first.x - shift(row), and at row + first_row() =
  /// first.y - samples_per_mm.y place.y; where lenses do not cover whole pixels, to half a pixel's direction.
  struct Sight {
    Vec2f k{0.0f}, first{0.0f};
  };
  const Sight& sight(int view) const { return sights_[static_cast<std::size_t>(view)]; }
  /// By row, from -kBeyond to size().y + kBeyond - 1: where its first lens is, in columns.
  const float* shifts() const { return shifts_.data() + kBeyond; }
  static constexpr int kBeyond = 2;
  int first_row() const { return first_row_; }  ///< row 0 in the views of the whole film
  float vergence() const { return vergence_; }  ///< 1 / V, per mm
  Vec2f samples_per_mm() const { return samples_per_mm_; }

  /// From sample to sample of a view in the plane z = 0, the larger of both axes.
  float sample_distance_mm() const { return std::max(1.0f / samples_per_mm_.x, 1.0f / samples_per_mm_.y); }

 private:
  void sort_by_tiles(const Optics& optics, RowRange rows);
  void sort_by_lenses(const Optics& optics, const LensCells& cells, RowRange rows);
  /// The view nearest to a column and row of views, in that row, that has no pixel at (x, y) so far; -1: none.
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
