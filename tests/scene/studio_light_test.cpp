#include "scene/studio_light.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/default_view.hpp"

namespace lippmann {
namespace {

constexpr Quatf kStraight{1.0f, 0.0f, 0.0f, 0.0f};

struct Texel {
  Vec3f direction;
  float steradians;
};

Texel texel_at(const EnvironmentMap& map, int x, int y) {
  const Image& image = map.radiance;
  const float polar = (static_cast<float>(y) + 0.5f) * kPi / static_cast<float>(image.height);
  const float azimuth = ((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width) - 0.5f) * 2.0f * kPi + map.rotation;
  const float sine = std::sin(polar), area = 2.0f * kPi * kPi / static_cast<float>(image.width * image.height);
  return {{sine * std::cos(azimuth), std::cos(polar), sine * std::sin(azimuth)}, area * sine};
}

float shown_by_white(const EnvironmentMap& map, Vec3f normal) {
  double sum = 0.0;
  for (int y = 0; y < map.radiance.height; ++y)
    for (int x = 0; x < map.radiance.width; ++x) {
      const Texel texel = texel_at(map, x, y);
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(map.radiance.width) + static_cast<std::size_t>(x);
      sum +=
          static_cast<double>(map.radiance.data[3 * at] * texel.steradians * std::max(glm::dot(normal, texel.direction), 0.0f));
    }
  return map.strength * static_cast<float>(sum) / kPi;
}

TEST(StudioLight, is_grey) {
  const EnvironmentMap map = studio_environment(kStraight);
  ASSERT_EQ(map.radiance.channels, 3);
  for (std::size_t i = 0; i < map.radiance.data.size(); i += 3) {
    ASSERT_EQ(map.radiance.data[i], map.radiance.data[i + 1]);
    ASSERT_EQ(map.radiance.data[i], map.radiance.data[i + 2]);
    ASSERT_GT(map.radiance.data[i], 0.05f) << "mirrors have something to show wherever they look";
  }
}

// White surfaces must have a radiance above 0.5 where they face the viewer, and below 1 everywhere. Then the sRGB code
// of a grey with the reflectance 0.18 is between 85 and 118, and with 0.5 between 137 and 188.
TEST(StudioLight, grey_and_white_are_well_exposed) {
  const EnvironmentMap map = studio_environment(kStraight);
  float most = 0.0f, least = 1e9f;
  for (int y = 4; y < map.radiance.height; y += 24)
    for (int x = 0; x < map.radiance.width; x += 24) {
      const float shown = shown_by_white(map, texel_at(map, x, y).direction);
      most = std::max(most, shown), least = std::min(least, shown);
    }
  EXPECT_LT(most, 1.0f);
  EXPECT_GT(most, 0.85f);
  EXPECT_GT(least, 0.1f) << "sees the floor alone";
  EXPECT_GT(shown_by_white(map, {0, 0, 1}), 0.5f) << "faces the viewer";
}

TEST(StudioLight, key_is_above_left_of_the_viewer) {
  for (const Quatf& viewer :
       {kStraight, default_view(), glm::angleAxis(2.0f, Vec3f(0, 1, 0)), glm::angleAxis(-0.5f * kPi, Vec3f(1, 0, 0))}) {
    const EnvironmentMap map = studio_environment(viewer);
    const Vec3f left = viewer * Vec3f(-1, 0, 0);
    EXPECT_GT(shown_by_white(map, left), 1.2f * shown_by_white(map, -left));
    EXPECT_GT(shown_by_white(map, {0, 1, 0}), 2.0f * shown_by_white(map, {0, -1, 0}));
  }
}

}  // namespace
}  // namespace lippmann
