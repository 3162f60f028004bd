// Rays of a quilt: views side by side on one panel, each an off-axis (sheared) pinhole through the same rectangle of z = 0.
//
// Tiles are floor(width / columns) x floor(height / rows) pixels, anchored at the bottom left; what is left over at the top and
// at the right is padding, whose pixels continue the view next to them and see no point. View v lies at column v mod columns,
// row floor(v / columns) from the bottom; its eye is at (distance tan(cone ((v + 1/2) / N - 1/2)), 0, distance).
#pragma once

#include <span>
#include <vector>

#include "optics/crossing.hpp"
#include "optics/optics.hpp"

namespace lippmann {

struct MultiViewRays {
  float columns, rows;
  float tile_width_px, tile_height_px, tiles_per_px_x, tiles_per_px_y;
  float padding_top_px;
  float pixel_pitch_mm;
  float inverse_distance;   ///< per mm
  float front_from_eye_mm;  ///< z_front - distance, <= 0
};

MultiViewRays make_multi_view(const Panel& panel, const MultiView& views, float z_front_mm);

/// x of the eye of view v, mm.
float eye_x_mm(const MultiView& views, int v);
/// The same for all views in order.
std::vector<float> eyes_x_mm(const MultiView& views);

/// Where a panel point lies in the quilt.
struct TilePoint {
  int view;
  float x, y;  ///< pixels from the tile's top left corner
};

/// Half-open tiles: floor((p - column width) / width) corrected so that rounding never moves an edge.
LIPPMANN_INLINE float tile_index(float p, float size, float per_px, float count) {
  float k = std::floor(p * per_px);
  const float in_tile = p - k * size;
  k += in_tile < 0.0f ? -1.0f : in_tile >= size ? 1.0f : 0.0f;
  k = k < count - 1.0f ? k : count - 1.0f;
  return k > 0.0f ? k : 0.0f;
}

LIPPMANN_INLINE TilePoint tile_point(const MultiViewRays& c, float px, float py) {
  const float down = py - c.padding_top_px;
  const float column = tile_index(px, c.tile_width_px, c.tiles_per_px_x, c.columns);
  const float row = tile_index(down, c.tile_height_px, c.tiles_per_px_y, c.rows);
  return {static_cast<int>((c.rows - 1.0f - row) * c.columns + column), px - column * c.tile_width_px,
          down - row * c.tile_height_px};
}

LIPPMANN_INLINE Crossing crossing(const MultiViewRays& c, const TilePoint& point, float eye_x) {
  const float x = (point.x - 0.5f * c.tile_width_px) * c.pixel_pitch_mm;
  const float y = (0.5f * c.tile_height_px - point.y) * c.pixel_pitch_mm;
  const float slope_x = (eye_x - x) * c.inverse_distance, slope_y = -y * c.inverse_distance;
  return {eye_x + c.front_from_eye_mm * slope_x, c.front_from_eye_mm * slope_y, slope_x, slope_y};
}

/// eyes_x: eyes_x_mm() of the views.
void write_rays(const MultiViewRays& constants, std::span<const float> eyes_x, const RayFrame& frame, const float* px,
                const float* py, int count, const RayArrays& rays);

void pixels_seeing(const Panel& panel, const MultiView& views, Vec3f point_mm, std::vector<Vec2f>& pixels);

}  // namespace lippmann
