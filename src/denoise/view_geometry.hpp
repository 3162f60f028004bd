// Where the points behind the pixels of a light field's views are, and where its other views show them.
//
// Views are stacked one below the other (layout/view_layout.hpp). Each is a picture in the plane z = 0 (optics/view_place.hpp):
// with x(z) = l + s z for one of its rays, k = l / V + s is the same for all of them, and it sees a point (X, z) at the place
//   (X - k z) / (1 - z / V),
// so that from view a to view b a point moves by (k_a - k_b) z / (1 - z / V). Here x points right and y down.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class ViewGeometry {
 public:
  /// `film`: where the views' pixels lie in the panel, `optics` has whole pixels per lens, or views.
  ViewGeometry(const Optics& optics, const ViewLayout& film);

  Vec2i view_size() const { return size_; }
  const ViewGrid& grid() const { return grid_; }
  int views() const { return grid_.count(); }
  /// Entry i: the panel's pixel that is pixel i of the stack.
  const std::vector<std::uint32_t>& pixels() const { return pixels_; }

  /// Where view `from` shows at `pixel` a point at depth z, view `to` shows it there; pixel coordinates of the views.
  Vec2f moved(Vec2f pixel, float z, int from, int to) const {
    return pixel + first_[at(from)] - first_[at(to)] + (slope_[at(from)] - slope_[at(to)]) * samples_per_mm_ * widening(z);
  }

  /// In mm, x to the right, y down, z towards the viewer.
  Vec3f point(Vec2f pixel, float z, int view) const {
    const Vec2f place = (pixel + first_[at(view)]) / samples_per_mm_;
    return Vec3f(place * (1.0f - z * vergence_) + slope_[at(view)] * z, z);
  }

  /// From sample to sample at depth z, mm, the larger of both axes.
  float sample_distance_mm(float z) const { return std::abs(1.0f - z * vergence_) * largest_step_mm_; }

 private:
  static std::size_t at(int view) { return static_cast<std::size_t>(view); }
  float widening(float z) const { return z / std::max(1.0f - z * vergence_, 1e-3f); }

  Vec2i size_{0};
  ViewGrid grid_;
  std::vector<std::uint32_t> pixels_;
  float vergence_ = 0.0f, largest_step_mm_ = 1.0f;
  Vec2f samples_per_mm_{1.0f};
  std::vector<Vec2f> first_;  ///< by view: place of pixel (0, 0), samples
  std::vector<Vec2f> slope_;  ///< by view: k
};

}  // namespace lippmann
