// Simulates pictures of textured discs in front of a wall, from a row of cameras that may be rotated, shifted and
// zoomed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "align/similarity.hpp"
#include "core/random.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann::test {

inline constexpr Vec2i kSceneSize{640, 480};
/// centre of the middle disc in camera 0's picture
inline constexpr Vec2d kSceneFocus{320.0, 240.0};
/// Shifts to the right in pixels, from one camera to the next, of the near discs, the middle disc and the wall.
inline constexpr double kNearMove = -6.0, kFocusMove = -2.0, kFarMove = 3.0;

/// Returns smooth noise from 0 to 1, interpolated between random values at multiples of `cell`.
inline double noise_at(Vec2d place, double cell, std::uint32_t seed) {
  const Vec2d at = place / cell, low = glm::floor(at);
  const Vec2d t = at - low, s = t * t * (3.0 - 2.0 * t);
  const auto value = [&](int x, int y) {
    return unit_float(hash(seed, static_cast<std::uint32_t>(static_cast<int>(low.x) + x),
                           static_cast<std::uint32_t>(static_cast<int>(low.y) + y)));
  };
  return (1.0 - s.y) * ((1.0 - s.x) * value(0, 0) + s.x * value(1, 0)) + s.y * ((1.0 - s.x) * value(0, 1) + s.x * value(1, 1));
}

inline double texture_at(Vec2d place, std::uint32_t seed) {
  return (noise_at(place, 37.0, seed) + noise_at(place, 13.0, seed + 1) + noise_at(place, 6.0, seed + 2)) / 3.0;
}

/// Returns the brightness of the aligned picture of camera `k` at `place`. Camera 0 is in the middle of the row.
inline double scene_at(Vec2d place, int k) {
  const Vec2d near = place - Vec2d(kNearMove * k, 0.0), middle = place - Vec2d(kFocusMove * k, 0.0);
  for (const Vec2d centre : {Vec2d(120.0, 110.0), Vec2d(520.0, 370.0), Vec2d(140.0, 380.0)})
    if (glm::length(near - centre) < 70.0) return texture_at(near, 11);
  if (glm::length(middle - kSceneFocus) < 90.0) return texture_at(middle, 21);
  return texture_at(place - Vec2d(kFarMove * k, 0.0), 31);
}

inline Similarity moved_about_centre(double turn_deg, double scale, Vec2d shift) {
  const double angle = turn_deg * std::numbers::pi / 180.0;
  Similarity moved{scale * std::cos(angle), scale * std::sin(angle), 0.0, 0.0};
  const Vec2d centre = 0.5 * Vec2d(kSceneSize), offset = centre + shift - moved(centre);
  moved.x = offset.x, moved.y = offset.y;
  return moved;
}

/// `moved` maps pixels of the result to pixels of the aligned picture.
inline Image8 shot(int k, const Similarity& moved) {
  Image8 picture{kSceneSize.x, kSceneSize.y, {}};
  picture.rgb.reserve(std::size_t{3} * kSceneSize.x * kSceneSize.y);
  for (int y = 0; y < kSceneSize.y; ++y)
    for (int x = 0; x < kSceneSize.x; ++x) {
      const auto code = static_cast<unsigned char>(20.0 + 215.0 * scene_at(moved(Vec2d(x + 0.5, y + 0.5)), k));
      picture.rgb.insert(picture.rgb.end(), {code, code, code});
    }
  return picture;
}

}  // namespace lippmann::test
