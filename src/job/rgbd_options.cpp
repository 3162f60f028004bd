#include "job/rgbd_options.hpp"

#include <fmt/format.h>

#include "formats/rgbd_side_file.hpp"
#include "frames/frame.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "stage/seen_depth.hpp"

namespace lippmann {
namespace {

EyeAtWindow written_eye(const Optics& optics) {
  const std::optional<RenderedViews> rendered = rendered_views(optics);
  if (!rendered || !rendered->cameras)
    throw usage_error("layout", "these optics have no views that are seen from one point", "`layout` rgbd without `optics`");
  const ViewGrid& grid = rendered->film.grid;
  const int middle = grid.rows / 2 * grid.columns + grid.columns / 2;
  const Vec2d eye = rendered->cameras->eyes_mm.at(static_cast<std::size_t>(middle));
  return {Vec3f(Vec2f(eye), static_cast<float>(rendered->cameras->distance_mm)), window_size_mm(optics)};
}

DepthRange range_of_scene(const Stage& stage, const EyeAtWindow& eye, const ThreadPool& pool) {
  const auto seen = seen_depth(stage.scene, stage.array, stage.placed.units_per_mm, eye, pool);
  return seen ? range_before_eye({seen->near_mm, seen->far_mm}, eye.eye_mm.z) : DepthRange{};
}

void require_before_eye(const DepthRange& range, double distance_mm) {
  if (range.near_mm < 0.999 * distance_mm) return;
  throw usage_error("depth-range",
                    fmt::format("{:g} mm does not lie in front of the eye, which is at {:.4g} mm", range.near_mm, distance_mm),
                    fmt::format("depths below {:.4g} mm", distance_mm));
}

}  // namespace

FormatOptions rgbd_options(const DepthParams& wanted, const Stage& stage, const ThreadPool& pool) {
  const EyeAtWindow eye = written_eye(stage.placed.optics);
  FormatOptions options;
  options.depth_range = wanted.range ? *wanted.range : range_of_scene(stage, eye, pool);
  require_before_eye(*options.depth_range, eye.eye_mm.z);
  options.even_in_depth = wanted.linear == DepthScale::kDepth;
  options.near_black = wanted.near_black;
  return options;
}

}  // namespace lippmann
