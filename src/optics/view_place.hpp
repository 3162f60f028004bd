// Maps a point to the sample grid of a directional view.
//
// A directional view consists of all pixels at the same offset below their lenses, or of a tile of a quilt. Its rays meet in a
// point of the viewer's plane z = V, or are parallel if V is infinite. Therefore the view is a picture in the plane z = 0, with
// one sample per lens (lens arrays) or per pixel (quilts and single views). Let x(z) = l + s z be the line of any ray of the
// view. The view sees a point P at the position
//   (P - (l / V + s) P_z) / (1 - P_z / V)
// in the plane z = 0, x right and y up. Divided by the sample spacing, with y downwards, this is a position in samples.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class ViewPlaces {
 public:
  /// `optics` must pass validate().
  explicit ViewPlaces(const Optics& optics);

  /// Returns 1 / (viewer's distance), per mm; 0 if the rays of a view are parallel.
  double vergence() const { return vergence_; }
  /// Returns the number of samples of a view per mm in the plane z = 0, to the right and down. For slanted panels, returns the
  /// number of pixels per mm.
  glm::dvec2 samples_per_mm() const { return samples_per_mm_; }

  /// Returns the position at which a view sees a point, in samples right and down from x = y = 0. `ray` is any ray of the view,
  /// in mm of the display frame. Returns nothing if the point is not in front of the viewer.
  std::optional<Vec2f> place_in_view(const Ray& ray, Vec3f point_mm) const;

 private:
  double vergence_ = 0.0;
  glm::dvec2 samples_per_mm_{1.0};
};

}  // namespace lippmann
