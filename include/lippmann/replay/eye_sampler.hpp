// Samples what one eye, possibly at infinity, sees at points of the display plane.
#pragma once

#include <memory>

#include "lippmann/optics/viewer.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/replay/taps.hpp"

namespace lippmann {

/// `rendered` must outlive this object. See EyeView for `filter` and `crosstalk_px`.
class EyeSampler {
 public:
  EyeSampler(const RenderedPanel& rendered, SampleFilter filter, double crosstalk_px = 0.0);
  ~EyeSampler();
  EyeSampler(EyeSampler&&) noexcept;
  EyeSampler(const EyeSampler&) = delete;
  EyeSampler& operator=(const EyeSampler&) = delete;

  /// Returns the linear colour at a point of the display plane. Thread-safe.
  Vec3f color(const Viewer& viewer, Vec2d point_mm) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the fraction of the lenses through which the eye sees a neighbouring viewing zone. Quilts have no lenses, so for
/// them, returns the fraction of points of the display.
double share_out_of_zone(const Optics& optics, const Viewer& viewer);

}  // namespace lippmann
