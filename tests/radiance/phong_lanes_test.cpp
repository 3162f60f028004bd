// Whitted's surfaces sixteen at once against PhongBsdf, which has tests of its own.
#include "radiance/phong_lanes.hpp"

#include <gtest/gtest.h>

#include <random>

#include "transport/phong_bsdf.hpp"

namespace lippmann {
namespace {

constexpr float kFaint = 8.0f;

/// Sixteen points of as many materials, seen from above through a pinhole, by paths that have lost some light.
struct Points {
  explicit Points(unsigned seed) : random(seed) {
    for (int i = 0; i < kLanes; ++i) {
      lanes.lane[i] = surface.hit.lane[i] = -1;
      surface.position.set(i, {between(-1, 1), between(-1, 1), between(-1, 1)});
      surface.normal.set(i, glm::normalize(Vec3f(between(-0.3f, 0.3f), between(-0.3f, 0.3f), 1.0f)));
      surface.facet.set(i, 0.1f * Vec3f(between(-0.3f, 0.3f), between(-0.3f, 0.3f), 1.0f));
      surface.entering.lane[i] = between(0, 1) < 0.5f ? -1 : 0;
      surface.t_near[i] = 1e-4f;
      surface.color.set(i, {between(0, 1), between(0, 1), between(0, 1)});
      surface.ambient.set(i, Vec3f(between(0, 0.2f)));
      surface.emission.set(i, Vec3f(i % 4 == 0 ? 1.0f : 0.0f));
      surface.diffuse[i] = i % 5 == 0 ? 0.0f : between(0, 1);
      surface.highlight[i] = i % 3 == 0 ? 0.0f : between(0, 1);
      surface.highlight_size[i] = between(1, 60);
      surface.highlight_tint[i] = between(0, 1);
      surface.mirror[i] = i % 4 == 1 ? 0.0f : between(0, 0.5f);
      surface.mirror_tint[i] = between(0, 1);
      surface.opacity[i] = i % 4 == 2 ? 1.0f : between(0.2f, 1.0f);
      surface.ior[i] = i % 2 == 0 ? 1.0f : between(1.1f, 1.9f);
      const Vec3f view = glm::normalize(Vec3f(between(-1, 1), between(-1, 1), -1.0f));
      rays.dir_x[i] = view.x, rays.dir_y[i] = view.y, rays.dir_z[i] = view.z;
      paths.throughput.set(i, {between(0, 1), between(0, 1), between(0, 1)});
    }
  }

  float between(float least, float most) { return std::uniform_real_distribution<float>(least, most)(random); }

  PhongBsdf bsdf(int i, bool tachyon) const {
    const float itself = tachyon ? 1.0f : surface.opacity[i];
    const Vec3f color = surface.color.get(i);
    PhongPoint p;
    p.diffuse = itself * surface.diffuse[i] * color;
    p.highlight = itself * surface.highlight[i] * glm::mix(Vec3f(1.0f), color, surface.highlight_tint[i]);
    p.highlight_size = surface.highlight_size[i];
    p.mirror = surface.mirror[i] * glm::mix(Vec3f(1.0f), color, surface.mirror_tint[i]);
    p.through = 1.0f - surface.opacity[i];
    p.ior = surface.ior[i];
    return {p, surface.normal.get(i), -direction(i), surface.entering.lane[i] != 0};
  }
  Vec3f direction(int i) const { return {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]}; }

  std::mt19937 random;
  LaneMask lanes;
  SurfacePacket surface{};
  RayPacket rays{};
  PathLanes paths{};
};

void expect_near(Vec3f found, Vec3f expected, int lane) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5f + 2e-4f * std::abs(expected[c])) << lane;
}

TEST(PhongLanes, a_point_light_is_reflected_as_the_bsdf_says) {
  int lit = 0, dark = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Points points(seed);
    const bool tachyon = seed % 2 == 0;
    PhongLanes phong;
    evaluate_phong(points.surface, tachyon, points.lanes, phong);
    WhittedLight light;
    light.position = {points.between(-3, 3), points.between(-3, 3), points.between(-0.5f, 3)};
    light.falls_off = 1.0f;
    ShadowPacket aimed;
    aim_at_light(light, points.surface, 0.0f, aimed);
    const Vec3f irradiance(3.0f, 2.0f, 1.0f);
    Lanes3 radiance;
    const int count =
        reflect_light({points.surface, phong, points.paths, points.rays, points.lanes}, irradiance, aimed, radiance);
    int active = 0;
    for (int i = 0; i < kLanes; ++i) {
      const Vec3f to = light.position - points.surface.position.get(i), way = glm::normalize(to);
      const PhongBsdf bsdf = points.bsdf(i, tachyon);
      const Vec3f expected =
          points.paths.throughput.get(i) * (bsdf.evaluate(way).cosine_f + bsdf.highlight(way)) * irradiance / glm::dot(to, to);
      const bool arrives = bsdf.evaluate(way).density + luminance(bsdf.highlight(way)) > 0.0f &&
                           glm::dot(points.surface.facet.get(i), way) > 0.0f;
      EXPECT_EQ(aimed.active.lane[i] != 0, arrives) << i;
      if (arrives) expect_near(radiance.get(i), expected, i);
      active += aimed.active.lane[i] != 0;
      ++(arrives ? lit : dark);
    }
    EXPECT_EQ(count, active);
  }
  EXPECT_GT(lit, 300);
  EXPECT_GT(dark, 50);
}

TEST(PhongLanes, mirrors_and_what_lies_behind_are_chosen_as_the_bsdf_does) {
  int mirrored = 0, straight = 0, refracted = 0, ended = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Points points(seed);
    PhongLanes phong;
    evaluate_phong(points.surface, false, points.lanes, phong);
    Lanes lobe, survival;
    for (int i = 0; i < kLanes; ++i) lobe[i] = points.between(0, 1), survival[i] = points.between(0, 1);
    GlossyRays gloss;
    reflect_gloss({points.surface, phong, points.paths, points.rays, points.lanes}, lobe, survival, kFaint, gloss);
    for (int i = 0; i < kLanes; ++i) {
      PhongBsdf bsdf = points.bsdf(i, false);
      bsdf.remove_diffuse();
      const std::optional<BsdfSample> sample = bsdf.sample(lobe[i], Vec2f(0.0f));
      Vec3f throughput(0.0f);
      bool goes_on = false;
      if (sample && (glm::dot(points.surface.facet.get(i), sample->direction) < 0.0f) == sample->transmitted) {
        throughput = points.paths.throughput.get(i) * sample->weight;
        const float chance = std::min(1.0f, kFaint * std::max({throughput.x, throughput.y, throughput.z}));
        goes_on = survival[i] < chance;
        throughput /= chance;
      }
      EXPECT_EQ(gloss.active.lane[i] != 0, goes_on) << i;
      ended += !goes_on;
      if (!goes_on) continue;
      expect_near(gloss.direction.get(i), sample->direction, i);
      expect_near(gloss.throughput.get(i), throughput, i);
      EXPECT_EQ(gloss.straight.lane[i] != 0, sample->straight) << i;
      ++(sample->straight ? straight : sample->transmitted ? refracted : mirrored);
    }
  }
  for (const int count : {mirrored, straight, refracted, ended}) EXPECT_GT(count, 40);
}

TEST(PhongLanes, ambient_light_is_emission_only_of_what_no_light_is_answered_by) {
  Points points(1);
  PhongLanes phong;
  evaluate_phong(points.surface, true, points.lanes, phong);
  EXPECT_TRUE(phong.any_emission && phong.any_gloss && phong.any_highlight);
  for (int i = 0; i < kLanes; ++i) {
    Vec3f expected = points.surface.emission.get(i);
    if (points.surface.diffuse[i] == 0.0f) expected += points.surface.ambient.get(i) * points.surface.color.get(i);
    expect_near(phong.emission.get(i), expected, i);
  }
}

TEST(PhongLanes, nobody_asks_for_what_only_other_lanes_have) {
  Points points(1);
  for (int i = 0; i < kLanes; ++i) points.lanes.lane[i] = 0;
  PhongLanes phong;
  evaluate_phong(points.surface, true, points.lanes, phong);
  EXPECT_FALSE(phong.any_emission || phong.any_gloss || phong.any_highlight);
}

}  // namespace
}  // namespace lippmann
