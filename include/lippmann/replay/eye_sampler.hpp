// What one eye, infinitely far or not, sees at points of the display plane: what eye views and epipolar-plane images are made
// of.
#pragma once

#include <memory>

#include "lippmann/optics/viewer.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// `rendered` must outlive it. Filter and crosstalk as in EyeView (replay/eye_view.hpp).
class EyeSampler {
 public:
  EyeSampler(const RenderedPanel& rendered, SampleFilter filter, double crosstalk_px = 0.0);
  ~EyeSampler();
  EyeSampler(EyeSampler&&) noexcept;
  EyeSampler(const EyeSampler&) = delete;
  EyeSampler& operator=(const EyeSampler&) = delete;

  /// Thread-safe.
  Vec3f color(const Viewer& viewer, Vec2d point_mm) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The share of lenses (of a quilt: of points) through which that eye sees what was made for another zone: where it flips.
double share_out_of_zone(const Optics& optics, const Viewer& viewer);

}  // namespace lippmann
