// Where a directional view sees a point: the place on that view's own grid of samples.
//
// The rays of one directional view (of all pixels at one offset below their lenses, of one tile of a quilt) meet in one
// point of the viewer's plane z = V, or are parallel where V is infinite. A view is thus a picture in the plane z = 0, with one
// sample per lens and row (of lens arrays) or per pixel (of views). With the line x(z) = l + s z of any of its rays, it sees a
// point P at
//   ((P - (l / V + s) P_z) / (1 - P_z / V)
// in that plane, across and up alike; divided by the distance of its samples, right and down, that is a place in its pixels.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class ViewPlaces {
 public:
  /// `optics` must pass validate().
  explicit ViewPlaces(const Optics& optics);

  /// 1 / V, per mm; 0: parallel.
  double vergence() const { return vergence_; }
  /// From sample to sample of a view in the plane z = 0, right and down. Below a slanted sheet: along the row, and from row to
  /// row. Of slanted panels the panel's whole pixels, though every view has samples on some sub-pixels only.
  glm::dvec2 samples_per_mm() const { return samples_per_mm_; }

  /// In samples, right and down, from where the view sees the middle of the plane z = 0. `ray` is any of the view's, in display
  /// mm. None where the point is not in front of the viewer.
  std::optional<Vec2f> place_in_view(const Ray& ray, Vec3f point_mm) const;

 private:
  double vergence_ = 0.0;
  glm::dvec2 samples_per_mm_{1.0};
};

}  // namespace lippmann
