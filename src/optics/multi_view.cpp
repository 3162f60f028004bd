#include "optics/multi_view.hpp"

namespace lippmann {
namespace {

/// The angles of the eyes, seen from the centre of the panel.
struct EyeAngles {
  double first, step;
};

EyeAngles eye_angles(const MultiView& views) {
  const int count = views.columns * views.rows;
  const double cone = views.baseline_mm > 0.0f ? 0.0 : views.view_cone;
  const double shift = views.eye_shift.x;
  if (!views.cone_ends_included) return {cone * ((0.5 + shift) / count - 0.5), cone / count};
  return count > 1 ? EyeAngles{cone * (shift / (count - 1) - 0.5), cone / (count - 1)} : EyeAngles{0.0, 0.0};
}

/// Of one axis of a camera grid: from its middle to its first eye.
double first_eye(double baseline_mm, int count, float shift) { return baseline_mm * (shift - 0.5 * (count - 1)); }

}  // namespace

EyeMm eye_of_view(const MultiView& views, int view) {
  const EyeAngles angles = eye_angles(views);
  const double baseline = views.parallax * views.baseline_mm, reach = views.parallax * views.distance_mm;
  return {reach * std::tan(angles.first + view * angles.step) + first_eye(baseline, views.columns, views.eye_shift.x) +
              view % views.columns * baseline,
          first_eye(baseline, views.rows, views.eye_shift.y) + view / views.columns * baseline};
}

MultiViewRays make_multi_view(const Panel& panel, const MultiView& views, float z_front_mm) {
  const int tile_width = panel.width / views.columns, tile_height = panel.height / views.rows;
  const EyeAngles angles = eye_angles(views);
  MultiViewRays c{};
  c.columns = static_cast<float>(views.columns), c.rows = static_cast<float>(views.rows);
  c.tile_width_px = static_cast<float>(tile_width), c.tile_height_px = static_cast<float>(tile_height);
  c.tiles_per_px_x = 1.0f / c.tile_width_px, c.tiles_per_px_y = 1.0f / c.tile_height_px;
  c.padding_top_px = static_cast<float>(panel.height - views.rows * tile_height);
  c.pixel_pitch_mm = panel.pixel_pitch_mm, c.pixel_height_mm = panel.pixel_pitch_mm * views.pixel_height;
  c.first_half_angle = static_cast<float>(0.5 * angles.first), c.half_angle_step = static_cast<float>(0.5 * angles.step);
  const double baseline = views.parallax * views.baseline_mm;
  c.first_eye_mm =
      Vec2f(first_eye(baseline, views.columns, views.eye_shift.x), first_eye(baseline, views.rows, views.eye_shift.y));
  c.baseline_mm = static_cast<float>(baseline);
  c.eye_reach_mm = views.parallax * views.distance_mm;
  c.distance_mm = views.distance_mm, c.inverse_distance = 1.0f / views.distance_mm;
  c.front_from_eye_mm = z_front_mm - views.distance_mm;
  return c;
}

LIPPMANN_MULTIVERSION
void write_block(const MultiViewRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void pixels_seeing(const Panel& panel, const MultiView& views, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = views.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double magnification = distance / from_eye, m = panel.pixel_pitch_mm;
  const int width = panel.width / views.columns, height = panel.height / views.rows;
  for (int v = 0; v < views.columns * views.rows; ++v) {
    const EyeMm eye = eye_of_view(views, v);
    const double x = 0.5 * width + (eye.x + (point_mm.x - eye.x) * magnification) / m;
    const double y = 0.5 * height - (eye.y + (point_mm.y - eye.y) * magnification) / (m * views.pixel_height);
    if (!(x >= 0.0 && x < width && y >= 0.0 && y < height)) continue;
    pixels.emplace_back(v % views.columns * width + x, panel.height - (v / views.columns + 1) * height + y);
  }
}

}  // namespace lippmann
