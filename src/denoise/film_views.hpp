// The pixels of a film, sorted into views: grids of pixels that look in about the same direction.
//
// A view is a picture in the plane z = 0 (optics/view_place.hpp). With x(z) = l + s z for one of its rays, k = l / V + s is the
// same for all of them, and it sees a point (X, z) at the place (X - k z) / (1 - z / V). Display frame: mm, y up.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class FilmViews {
 public:
  static constexpr std::uint32_t kNoPixel = 0xffffffff;

  /// `film`: where the views' pixels lie in the film.
  FilmViews(const Optics& optics, const ViewLayout& film);

  Vec2i film_size() const { return film_; }
  /// Columns and rows of a view.
  Vec2i size() const { return size_; }
  /// Views across and up: view v = row * columns + column.
  const ViewGrid& grid() const { return grid_; }
  int views() const { return grid_.count(); }

  /// The film's pixels in row y of a view, or kNoPixel; as many as a view has columns.
  const std::uint32_t* row(int view, int y) const {
    return pixels_.data() + (static_cast<std::size_t>(view) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(y)) *
                                static_cast<std::size_t>(size_.x);
  }

  /// How a view sees points: at column = samples_per_mm.x place.x - first.x, row = first.y - samples_per_mm.y place.y.
  struct Sight {
    Vec2f k{0.0f}, first{0.0f};
  };
  const Sight& sight(int view) const { return sights_[static_cast<std::size_t>(view)]; }
  float vergence() const { return vergence_; }  ///< 1 / V, per mm
  Vec2f samples_per_mm() const { return samples_per_mm_; }

  /// From sample to sample of a view in the plane z = 0, the larger of both axes.
  float sample_distance_mm() const { return std::max(1.0f / samples_per_mm_.x, 1.0f / samples_per_mm_.y); }

 private:
  Vec2i film_{0}, size_{0};
  ViewGrid grid_;
  std::vector<std::uint32_t> pixels_;
  std::vector<Sight> sights_;
  float vergence_ = 0.0f;
  Vec2f samples_per_mm_{1.0f};
};

}  // namespace lippmann
