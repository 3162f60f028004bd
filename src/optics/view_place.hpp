// Maps a point to the sample grid of a directional view.
//
// The rays of one directional view (all pixels at one offset below their lenses, or one tile of a quilt) meet in a point of the
// viewer's plane z = V, or are parallel if V is infinite. Therefore a view is a picture in the plane z = 0, with one sample per
// lens and row (lens arrays) or per pixel (views). Given the line x(z) = l + s z of any ray of the view, the view sees a point
// P in that plane at
//   (P - (l / V + s) P_z) / (1 - P_z / V),
// across and up. Divided by the sample spacing, and with y downwards, this is a position in the view's pixels.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class ViewPlaces {
 public:
  /// `optics` must pass validate().
  explicit ViewPlaces(const Optics& optics);

  /// Returns 1 / V, per mm; 0 if the rays of a view are parallel.
  double vergence() const { return vergence_; }
  /// Returns the number of samples per mm of a view in the plane z = 0, right and down. For a slanted sheet: along the row, and
  /// from row to row. For slanted panels, the panel's whole pixels are counted, although each view has samples only on some of
  /// the sub-pixels.
  glm::dvec2 samples_per_mm() const { return samples_per_mm_; }

  /// Returns the position at which the view of `ray` sees a point, in samples right and down from the middle of the plane z =
  /// 0. `ray` is any ray of the view, in display mm. Returns none if the point is not in front of the viewer.
  std::optional<Vec2f> place_in_view(const Ray& ray, Vec3f point_mm) const;

 private:
  double vergence_ = 0.0;
  glm::dvec2 samples_per_mm_{1.0};
};

}  // namespace lippmann
