// Tests normals whose mirror direction would point below the facet.
#include "shading/lifted_normal.hpp"

#include <numbers>

#include "trace/coarse_ball.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

Vec3f mirrored_at(Vec3f normal, Vec3f view) { return 2.0f * glm::dot(normal, view) * normal - view; }

Vec3f upwards(std::mt19937& random) {
  std::uniform_real_distribution<float> in_unit(1e-3f, 1.0f), turn(0.0f, 2.0f * std::numbers::pi_v<float>);
  const float z = in_unit(random), r = std::sqrt(1.0f - z * z), phi = turn(random);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(LiftedNormal, stays_if_its_mirror_direction_is_valid) {
  const Vec3f normal = glm::normalize(Vec3f(0.3f, -0.2f, 1.0f)), view = glm::normalize(Vec3f(0.1f, 0.4f, 1.0f));
  EXPECT_EQ(lifted_normal(normal, {0, 0, 7}, view), normal);
  EXPECT_EQ(lifted_normal({0, 0, 1}, {0, 0, 2}, glm::normalize(Vec3f(1.0f, 0.0f, 1e-3f))), Vec3f(0, 0, 1));
}

TEST(LiftedNormal, lifts_a_normal_as_computed_by_hand) {
  // Angles are measured from the facet's normal. The view is at -60 degrees, and the given normal at 80 degrees. The
  // mirror direction must have a height of at least 0.01 above the facet, so it is at acos(0.01) = 89.427 degrees. The
  // normal half-way between this direction and the view is at (89.427 - 60) / 2 = 14.7135 degrees.
  const auto at = [](float degrees) {
    const float a = degrees * std::numbers::pi_v<float> / 180.0f;
    return Vec3f(std::sin(a), 0.0f, std::cos(a));
  };
  expect_color(lifted_normal(at(80), {0, 0, 1}, at(-60)), at(14.7135f), 1e-4f);
}

TEST(LiftedNormal, mirrors_any_view_above_the_facet) {
  std::mt19937 random(3);
  int lifted = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f view = upwards(random), normal = upwards(random), z(0, 0, 1), got = lifted_normal(normal, {0, 0, 0.1f}, view);
    const float height = std::min(0.9f * view.z, 0.01f);
    EXPECT_GE(mirrored_at(got, view).z, height - 1e-6f);
    EXPECT_GT(glm::dot(got, view), 0.0f);
    EXPECT_NEAR(glm::length(got), 1.0f, 1e-5f);
    if (got == normal) continue;
    ++lifted;
    EXPECT_NEAR(mirrored_at(got, view).z, height, 1e-6f);                  // not lifted further than necessary
    EXPECT_NEAR(glm::dot(glm::cross(normal, z), got), 0.0f, 1e-5f);        // in the plane of the given and the facet's normal
    EXPECT_GE(glm::dot(got, z), normal.z - 1e-6f);                         // closer to the facet's normal than the given normal
    EXPECT_GE(glm::dot(glm::cross(z, normal), glm::cross(z, got)), 0.0f);  // on the same side of the facet's normal
  }
  EXPECT_GT(lifted, 500);
}

TEST(LiftedNormal, degenerate_normals_become_the_facets) {
  const Vec3f view = glm::normalize(Vec3f(1.0f, 0.0f, 1.0f));
  EXPECT_EQ(lifted_normal({0, 0, -1}, {0, 0, 1}, view), Vec3f(0, 0, 1));
  // A facet without area has no normal.
  EXPECT_EQ(lifted_normal({1, 0, 0}, {0, 0, 0}, view), Vec3f(1, 0, 0));
}

Image in_white_furnace(const MetallicRoughness& surface, int size) {
  SmallScene s;
  surround(s, Vec3f(1.0f));
  s.add(coarse_ball(1.5f, 6), s.material(surface));
  return trace_paths(s.scene, single_view(size), 64).film;
}

MetallicRoughness of(float metallic, float roughness) {
  MetallicRoughness surface;
  surface.metallic = metallic, surface.roughness = roughness;
  return surface;
}

// If the smooth normal faces away from the view, a gloss without lifted normals would hide the paint below it. The
// darkest of every 500 pixels would then show 0.82 of the sky's light instead of 0.91.
TEST(LiftedNormal, glossy_coarse_balls_have_no_dark_rim) {
  for (const bool layered : {false, true}) {
    MetallicRoughness paint = of(0.0f, 0.3f);
    if (layered) paint.extensions.emplace().sheen.color = Vec3f(1e-6f);
    std::vector<float> values = in_white_furnace(paint, 160).data;
    const auto darkest = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 500);
    std::nth_element(values.begin(), darkest, values.end());
    EXPECT_GT(*darkest, 0.87f) << layered;
  }
}

// A mirrored ray from a facet's edge may hit the adjacent facet, so the mean may lose 10^-4. A dark rim would lose all
// light of its pixels.
TEST(LiftedNormal, coarse_mirror_balls_have_no_dark_rim) {
  const std::vector<float> values = in_white_furnace(of(1.0f, 0.0f), 32).data;
  double sum = 0.0;
  for (const float value : values) {
    EXPECT_GT(value, 0.9f);
    EXPECT_LT(value, 1.001f);
    sum += static_cast<double>(value);
  }
  EXPECT_GT(sum / static_cast<double>(values.size()), 1.0 - 1e-4);
}

}  // namespace
}  // namespace lippmann
