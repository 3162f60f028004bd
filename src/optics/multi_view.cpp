#include "optics/multi_view.hpp"

namespace lippmann {

MultiViewRays make_multi_view(const Panel& panel, const MultiView& views, float z_front_mm) {
  const int tile_width = panel.width / views.columns, tile_height = panel.height / views.rows;
  MultiViewRays c{};
  c.columns = static_cast<float>(views.columns), c.rows = static_cast<float>(views.rows);
  c.tile_width_px = static_cast<float>(tile_width), c.tile_height_px = static_cast<float>(tile_height);
  c.tiles_per_px_x = 1.0f / c.tile_width_px, c.tiles_per_px_y = 1.0f / c.tile_height_px;
  c.padding_top_px = static_cast<float>(panel.height - views.rows * tile_height);
  c.pixel_pitch_mm = panel.pixel_pitch_mm;
  c.inverse_distance = 1.0f / views.distance_mm;
  c.front_from_eye_mm = z_front_mm - views.distance_mm;
  return c;
}

float eye_x_mm(const MultiView& views, int v) {
  const int count = views.columns * views.rows;
  double share = (v + 0.5) / count;
  if (views.cone_ends_included) share = count > 1 ? v / (count - 1.0) : 0.5;
  return static_cast<float>(views.distance_mm * std::tan(views.view_cone * (share - 0.5)));
}

std::vector<float> eyes_x_mm(const MultiView& views) {
  std::vector<float> eyes(static_cast<std::size_t>(views.columns) * views.rows);
  for (std::size_t v = 0; v < eyes.size(); ++v) eyes[v] = eye_x_mm(views, static_cast<int>(v));
  return eyes;
}

LIPPMANN_MULTIVERSION
void write_rays(const MultiViewRays& constants, std::span<const float> eyes_x, const RayFrame& frame, const float* px,
                const float* py, int count, const RayArrays& rays) {
  const MultiViewRays c = constants;
  const RayFrame f = frame;
  const RayArrays r = rays;
  const float* eyes = eyes_x.data();
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const TilePoint point = tile_point(c, px[i], py[i]);
    write_ray(f, crossing(c, point, eyes[point.view]), r, i);
  }
}

void pixels_seeing(const Panel& panel, const MultiView& views, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = views.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double magnification = distance / from_eye, m = panel.pixel_pitch_mm;
  const int width = panel.width / views.columns, height = panel.height / views.rows;
  const double y = 0.5 * height - point_mm.y * magnification / m;
  if (!(y >= 0.0 && y < height)) return;
  for (int v = 0; v < views.columns * views.rows; ++v) {
    const double eye = eye_x_mm(views, v);
    const double x = 0.5 * width + (eye + (point_mm.x - eye) * magnification) / m;
    if (!(x >= 0.0 && x < width)) continue;
    pixels.emplace_back(v % views.columns * width + x, panel.height - (v / views.columns + 1) * height + y);
  }
}

}  // namespace lippmann
