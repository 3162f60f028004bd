// The radiance of the studio is the sum of a smooth background (wall and floor) and several rectangular soft boxes. It is
// linear and grey.

#include "scene/studio_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lippmann {
namespace {

constexpr int kWidth = 512, kHeight = 256;

/// A rectangular light. The azimuth counts to the right of the view direction, the elevation from the horizon upwards. All
/// angles are in degrees.
struct SoftBox {
  float azimuth, elevation, half_width, half_height;
  float radiance;
};

constexpr SoftBox kBoxes[] = {
    {-140.0f, 45.0f, 22.0f, 18.0f, 5.4f},
    {120.0f, 25.0f, 14.0f, 24.0f, 1.5f},
    {15.0f, 65.0f, 26.0f, 11.0f, 1.8f},  // above and behind the subject, to separate its edges from the wall
};
constexpr float kHorizon = 0.32f, kZenith = 0.16f, kFloor = 0.12f;

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float wall(Vec3f d) {
  const float above = glm::mix(kHorizon, kZenith, smooth_step(0.0f, 0.9f, d.y));
  return glm::mix(kFloor, above, smooth_step(-0.35f, 0.05f, d.y));
}

/// Returns 1 inside the box, 0 outside, with a smooth transition.
float share_of(const SoftBox& box, Vec3f d) {
  constexpr float kEdge = 0.2f;
  const float azimuth = radians(box.azimuth), elevation = radians(box.elevation);
  const Vec3f right(std::cos(azimuth), 0.0f, std::sin(azimuth));
  const Vec3f centre(std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation));
  const float ahead = glm::dot(d, centre);
  if (ahead <= 0.0f) return 0.0f;
  const float x = glm::dot(d, right) / (ahead * std::tan(radians(box.half_width)));
  const float y = glm::dot(d, glm::cross(right, centre)) / (ahead * std::tan(radians(box.half_height)));
  return smooth_step(1.0f, 1.0f - kEdge, std::abs(x)) * smooth_step(1.0f, 1.0f - kEdge, std::abs(y));
}

float radiance(Vec3f d) {
  float sum = wall(d);
  for (const SoftBox& box : kBoxes) sum += box.radiance * share_of(box, d);
  return sum;
}

/// Returns the azimuth of the view direction, in radians from +x towards +z. If the viewer looks straight up or down, the
/// direction of the picture's top replaces it.
float heading(const Quatf& viewer) {
  Vec3f ahead = viewer * Vec3f(0.0f, 0.0f, -1.0f);
  if (std::hypot(ahead.x, ahead.z) < 1e-3f) ahead = viewer * Vec3f(0.0f, ahead.y < 0.0f ? 1.0f : -1.0f, 0.0f);
  return std::atan2(ahead.z, ahead.x);
}

}  // namespace

EnvironmentMap studio_environment(const Quatf& viewer) {
  EnvironmentMap map{Image(kWidth, kHeight, 3), 1.0f, heading(viewer) + 0.5f * kPi};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float polar = (static_cast<float>(y) + 0.5f) * kPi / kHeight;
      const float azimuth = ((static_cast<float>(x) + 0.5f) / kWidth - 0.5f) * 2.0f * kPi;
      const Vec3f d(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
      std::fill_n(map.radiance.data.data() + 3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)), 3,
                  radiance(d));
    }
  return map;
}

}  // namespace lippmann
