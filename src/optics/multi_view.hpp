// Computes the rays of a quilt: views side by side on one panel. Each view is an off-axis (sheared) pinhole through the same
// rectangle of the plane z = 0.
//
// 1. Tiles have floor(width / columns) x floor(height / rows) pixels and are anchored at the bottom left. Remaining pixels at
//    the top and at the right are padding. The rays of padding continue the adjacent view; pixels_seeing() skips padding.
// 2. The tile of view v is in column v mod columns and row floor(v / columns), counted from the bottom.
// 3. The eye of view v of N is at (distance tan(cone ((v + 1/2) / N - 1/2)), 0, distance). In a camera grid, the eye is at
//    (baseline (column - (columns - 1)/2), baseline (row - (rows - 1)/2), distance).
// 4. The eye's x and y are scaled by the parallax. Then the eye height is added to y.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/model.hpp"

namespace lippmann {

struct MultiViewRays {
  float columns, rows;
  float tile_width_px, tile_height_px, tiles_per_px_x, tiles_per_px_y;
  float padding_top_px;
  float pixel_pitch_mm, pixel_height_mm;
  float first_half_angle, half_angle_step;  ///< half the angle of view 0's eye, and half the angle between neighbouring views
  Vec2f first_eye_mm;                       ///< camera grid: position of the lower left eye; otherwise (0, eye height)
  float baseline_mm;                        ///< camera grid: distance between eyes; otherwise 0
  float eye_reach_mm;                       ///< an eye's x divided by the tangent of its angle
  float distance_mm, inverse_distance;
  float front_from_eye_mm;  ///< z of the plane z_front relative to the eye: z_front - distance, <= 0
};

struct EyeMm {
  double x, y;
};
EyeMm eye_of_view(const MultiView& views, int view);

MultiViewRays make_multi_view(const Panel& panel, const MultiView& views, float z_front_mm);

/// Returns the index of the tile of `size` pixels that contains p: floor(p / size), corrected for rounding at edges and clamped
/// to 0 ... count - 1.
LIPPMANN_INLINE float tile_index(float p, float size, float per_px, float count) {
  float k = std::floor(p * per_px);
  const float in_tile = p - k * size;
  k = in_tile < 0.0f ? k - 1.0f : k;
  k = in_tile >= size ? k + 1.0f : k;
  k = k < count - 1.0f ? k : count - 1.0f;
  return k > 0.0f ? k : 0.0f;
}

/// Returns tan(2 h) for |h| < pi/4. Computes tan h by Lambert's continued fraction up to the term h^2/9 (error 2e-8 at pi/4),
/// then applies the double-angle formula. Unlike std::tan(), it vectorises and gives the same bits on every machine.
LIPPMANN_INLINE float tangent_of_double(float h) {
  const float h2 = h * h;
  const float p = h * (945.0f + h2 * (h2 - 105.0f)), q = 945.0f + h2 * (15.0f * h2 - 420.0f);
  return 2.0f * p * q / ((q - p) * (q + p));
}

LIPPMANN_INLINE Crossing crossing(const MultiViewRays& c, float px, float py) {
  const float down = py - c.padding_top_px;
  const float column = tile_index(px, c.tile_width_px, c.tiles_per_px_x, c.columns);
  const float row = tile_index(down, c.tile_height_px, c.tiles_per_px_y, c.rows);
  const float x = (px - column * c.tile_width_px - 0.5f * c.tile_width_px) * c.pixel_pitch_mm;
  const float y = (0.5f * c.tile_height_px - (down - row * c.tile_height_px)) * c.pixel_height_mm;
  const float view = (c.rows - 1.0f - row) * c.columns + column;
  // One of the two terms of eye_x is always 0. Adding both avoids branches.
  const float on_cone = c.eye_reach_mm * tangent_of_double(c.first_half_angle + view * c.half_angle_step);
  const float eye_x = on_cone + (c.first_eye_mm.x + column * c.baseline_mm);
  const float eye_y = c.first_eye_mm.y + (c.rows - 1.0f - row) * c.baseline_mm;
  const float slope_x = (eye_x - x) * c.inverse_distance, slope_y = (eye_y - y) * c.inverse_distance;
  return {eye_x + c.front_from_eye_mm * slope_x, eye_y + c.front_from_eye_mm * slope_y, slope_x, slope_y};
}

void write_block(const MultiViewRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

class QuiltSight;

// The functions of optics/model.hpp follow.

constexpr std::string_view kind_of(const MultiView&) { return "multiview"; }
constexpr int sub_pixels_of(const MultiView&) { return 1; }
void check_model(const Panel& panel, const MultiView& views);
void write_model(const MultiView& views, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, MultiView& views);
OpticsFacts facts_of(const Panel& panel, const MultiView& views);
inline float front_mm(const Panel&, const MultiView& views, float chosen_mm) { return std::min(chosen_mm, views.distance_mm); }
inline MultiViewRays make_rays(const Panel& panel, const MultiView& views, float z_front_mm) {
  return make_multi_view(panel, views, z_front_mm);
}
inline Vec2f footprint_mm(const Panel& panel, const MultiView& views, float z_mm) {
  return Vec2f(1.0f, views.pixel_height) * (panel.pixel_pitch_mm * std::abs(1.0f - z_mm / views.distance_mm));
}
Vec2d zone_slope(const Panel& panel, const MultiView& views, Vec2d share);
StepRule step_rule(const Panel& panel, const MultiView& views, StepsWithin within);
void pixels_seeing(const Panel& panel, const MultiView& views, Vec3f point_mm, std::vector<Vec2f>& pixels);
QuiltSight sight_of(const Panel& panel, const MultiView& views);
std::optional<ViewCameras> cameras_of(const Panel& panel, const MultiView& views);
const OpticsKindInfo& kind_info(const MultiView&);

}  // namespace lippmann
