#include "lippmann/replay/disparity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

double depth_of_disparity_px(const Optics& optics, double disparity_px, const char* parameter) {
  const std::optional<RenderedViews> views = rendered_views(optics);
  if (!views || !views->cameras)
    throw usage_error(parameter, "is in px, but the cameras of these views are unknown", "a depth in mm");
  const ViewCameras& cameras = *views->cameras;
  const ViewGrid grid = views->film.grid;
  const double baseline_mm = mean_step(cameras.eyes_mm, grid);
  if (!(baseline_mm > 0.0)) throw usage_error(parameter, "is in px, but there is only one view", "several views");
  const double pixel_mm = grid.columns > 1 ? cameras.pixel_mm.x : cameras.pixel_mm.y;
  const double infinity_px = -baseline_mm / pixel_mm;
  if (!std::isfinite(disparity_px) || !(disparity_px > infinity_px))
    throw usage_error(parameter, fmt::format("is {} px, but points at infinity have {:.6g} px", disparity_px, infinity_px),
                      "a larger number");
  const double shift_mm = disparity_px * pixel_mm;
  return shift_mm * cameras.distance_mm / (baseline_mm + shift_mm);
}

}  // namespace lippmann
