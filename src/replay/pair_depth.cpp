#include "replay/pair_depth.hpp"

#include <algorithm>

#include "align/stereo_depth.hpp"
#include "formats/depth_map.hpp"
#include "formats/rendered.hpp"
#include "formats/rgbd_side_file.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

struct EyeSlopes {
  double left = 0.0, right = 0.0;
};

EyeSlopes slopes_of(const Optics& optics) {
  const std::optional<RenderedViews> rendered = rendered_views(optics);
  EyeSlopes slopes;
  if (rendered && rendered->cameras) {
    const ViewCameras& cameras = *rendered->cameras;
    const auto [left, right] = std::minmax_element(cameras.eyes_mm.begin(), cameras.eyes_mm.end(),
                                                   [](const Vec2d& a, const Vec2d& b) { return a.x < b.x; });
    slopes = {left->x / cameras.distance_mm, right->x / cameras.distance_mm};
  }
  if (!(slopes.left < slopes.right))
    throw usage_error("views", "no two views of the target lie side by side", "`views` with 2 or more columns");
  return slopes;
}

LightField picture_with_depth(const LightField& pair, int eye, const Image& disparity_px, const EyeSlopes& slopes) {
  const ViewCameras& camera = *pair.cameras;
  const double slope = eye == 0 ? slopes.left : slopes.right;
  LightField field;
  field.grid = {1, 1}, field.view_size = pair.view_size, field.aspect = pair.aspect;
  field.stack = view_of(pair, eye);
  // Neighbours whose disparities differ by less than 1.5 pixels belong to one surface.
  const float edge = 1.5f * static_cast<float>(pair.view_size.x) / static_cast<float>(disparity_px.width);
  field.depth = enlarged_depth(disparity_px, pair.view_size, edge);
  for (float& d : field.depth->data)
    d = static_cast<float>(depth_of_disparity(d * camera.pixel_mm.x / (slopes.right - slopes.left), camera.distance_mm));
  field.cameras = ViewCameras{camera.distance_mm, camera.pixel_mm, camera.centre_px, {Vec2d(slope * camera.distance_mm, 0.0)}};
  return field;
}

}  // namespace

std::vector<LightField> pictures_with_depth(const LightField& pair, const Optics& optics, const std::string& name,
                                            const Context& context) {
  const EyeSlopes slopes = slopes_of(optics);
  const StereoDisparity found = disparity_of_pair(view_of(pair, 0), view_of(pair, 1), name, context);
  return {picture_with_depth(pair, 0, found.of_left, slopes), picture_with_depth(pair, 1, found.of_right, slopes)};
}

}  // namespace lippmann
