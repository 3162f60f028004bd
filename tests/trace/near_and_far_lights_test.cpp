// Near lights fall off with distance, far lights do not. The eye at (0, 0, 1) sees the floor from -0.2 to 0.2 in x and y at z =
// 0.
#include <gtest/gtest.h>

#include <cmath>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

enum class Near { kNone, kPoint, kBall, kSquare, kDarkSquare };
enum class Far { kNone, kSky, kSunnySky, kLamp };
constexpr Near kNears[] = {Near::kPoint, Near::kBall, Near::kSquare};
constexpr Far kFars[] = {Far::kSky, Far::kSunnySky, Far::kLamp};

void add(SmallScene& s, Near near) {
  if (near == Near::kNone) return;
  if (near == Near::kSquare || near == Near::kDarkSquare) {
    add_lamp_facing_down(s, 0.25f, 2.0f, Vec3f(near == Near::kSquare ? 8.0f : 0.0f));
    std::get<MetallicRoughness>(s.scene.materials.back().surface).base_color = Vec4f(0, 0, 0, 1);
    return;
  }
  Light& lamp = s.point_light({0.5f, 0.0f, 2.0f}, Vec3f(4.0f));
  lamp.inverse_square = true;
  if (near == Near::kBall) lamp.radius = 0.2f;
}

void add(SmallScene& s, Far far) {
  if (far == Far::kSky) surround(s, Vec3f(0.3f));
  if (far == Far::kSunnySky) s.scene.background.map = sunny_sky(Vec3f(0.2f), {0.3f, 0.2f, 1.0f}, Vec3f(0.5f));
  if (far != Far::kLamp) return;
  Light& lamp = s.point_light({}, Vec3f(0.7f));
  lamp.kind = LightKind::kDirectional;
  s.scene.nodes[static_cast<std::size_t>(lamp.node)].matrix->linear = glm::mat3_cast(glm::angleAxis(0.6f, Vec3f(0, 1, 0)));
}

SmallScene floor_below(Near near, Far far, float half_size, float roughness = 1.0f) {
  MetallicRoughness surface;
  surface.metallic = roughness < 1.0f ? 1.0f : 0.0f, surface.roughness = roughness, surface.specular = surface.metallic;
  surface.base_color = Vec4f(0.5f, 0.5f, 0.5f, 1.0f);
  SmallScene s;
  s.add(square(half_size, 0.0f), s.material(surface));
  add(s, near);
  add(s, far);
  return s;
}

double noise(const Image& film) {
  const double average = mean(film);
  double squares = 0.0;
  for (const float value : film.data)
    squares += (static_cast<double>(value) - average) * (static_cast<double>(value) - average);
  return std::sqrt(squares / static_cast<double>(film.data.size())) / average;
}

double noise_below(Near near, Far far, float half_size) {
  return noise(trace_paths(floor_below(near, far, half_size).scene, single_view(32), 4, {}, 1, kNearby).film);
}

TEST(NearAndFarLights, noise_does_not_grow_with_the_floor) {
  for (const Near near : kNears)
    for (const Far far : kFars) {
      const double of_small = noise_below(near, far, 5.0f);
      EXPECT_LT(of_small, 0.5);
      for (const float half_size : {50.0f, 5000.0f})
        EXPECT_NEAR(noise_below(near, far, half_size), of_small, 0.03 * of_small)
            << static_cast<int>(near) << ", " << static_cast<int>(far) << ", floor of " << 2.0f * half_size;
    }
}

double light_below(Near near, Far far, float roughness) {
  return mean(trace_paths(floor_below(near, far, 5.0f, roughness).scene, single_view(16), 512, {}, 1, kNearby).film);
}

// On diffuse floors, shadow rays find most of the light; on glossy floors, reflected rays do.
TEST(NearAndFarLights, light_is_the_sum_of_both) {
  for (const float roughness : {1.0f, 0.3f})
    for (const Near near : kNears)
      for (const Far far : kFars) {
        const Near dark = near == Near::kSquare ? Near::kDarkSquare : Near::kNone;
        const double sum = light_below(near, Far::kNone, roughness) + light_below(dark, far, roughness);
        EXPECT_NEAR(light_below(near, far, roughness), sum, 0.015 * sum)
            << static_cast<int>(near) << ", " << static_cast<int>(far) << ", roughness " << roughness;
      }
}

}  // namespace
}  // namespace lippmann
