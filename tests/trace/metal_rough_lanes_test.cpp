// Sixteen surfaces at once must give the same bits as MetalRoughBsdf for each.
#include "shading/metal_rough_lanes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "shading/bsdf_packet.hpp"

namespace lippmann {
namespace {

const GgxAlbedo& albedo() {
  static const GgxAlbedo tables;
  return tables;
}

enum class Kind { kLambert, kGloss, kAny };

struct Points {
  Points(unsigned seed, Kind kind) : random(seed) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      MetalRoughSurface& s = surfaces[i];
      s.base_color = i % 5 == 0 ? Vec3f(0.0f) : Vec3f(between(0, 1), between(0, 1), between(0, 1));
      s.metallic = kind == Kind::kLambert || i % 3 == 0 ? 0.0f : i % 3 == 1 ? between(0, 1) : 1.0f;
      s.roughness = i % 4 == 0 ? 0.0f : between(0, 1);
      s.ior = i % 7 == 0 && kind != Kind::kAny ? 0.0f : between(1, 2.5f);
      if (kind == Kind::kAny) s.transmission = i % 4 == 3 ? 0.0f : i % 4 == 2 ? between(0, 1) : 1.0f;
      s.specular = kind == Kind::kLambert || i % 6 == 3 ? 0.0f : between(0, 1);
      s.specular_color = Vec3f(between(0, 30), between(0, 30), between(0, 30));
      normals[i].diffuse = direction();
      normals[i].gloss = i % 2 == 0 ? normals[i].diffuse : glm::normalize(normals[i].diffuse + 0.3f * direction());
      views[i] = glm::normalize(normals[i].gloss + (i % 8 == 5 ? 0.9999f : 0.9f) * direction());
    }
    lanes.clear();
    for (int i = 0; i < kLanes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      lanes.set(i, surfaces[k], normals[k], views[k], enters(i));
    }
    lanes.prepare(albedo());
  }

  float between(float least, float most) { return std::uniform_real_distribution<float>(least, most)(random); }
  Vec3f direction() { return glm::normalize(Vec3f(between(-1, 1), between(-1, 1), between(-1, 1)) + Vec3f(1e-3f)); }
  static bool enters(int i) { return i % 3 != 2; }
  MetalRoughBsdf bsdf(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {surfaces[k], albedo(), normals[k], views[k], enters(i)};
  }

  std::mt19937 random;
  std::array<MetalRoughSurface, kLanes> surfaces;
  std::array<MetalRoughBsdf::Normals, kLanes> normals;
  std::array<Vec3f, kLanes> views;
  MetalRoughLanes lanes;
};

void expect_values_of(Points& points) {
  Lanes3 lights;
  for (int i = 0; i < kLanes; ++i) lights.set(i, points.direction());
  BsdfValueLanes values;
  points.lanes.evaluate(albedo(), lights, values);
  for (int i = 0; i < kLanes; ++i) {
    const MetalRoughBsdf bsdf = points.bsdf(i);
    const BsdfValue expected = bsdf.evaluate(lights.get(i));
    EXPECT_EQ(values.cosine_f.get(i), expected.cosine_f) << i;
    EXPECT_EQ(values.density[i], expected.density) << i;
    EXPECT_EQ(values.get(i).transmitted, expected.transmitted) << i;
    EXPECT_EQ(points.lanes.evaluate_diffuse(i, albedo(), lights.get(i)), bsdf.evaluate_diffuse(lights.get(i))) << i;
    EXPECT_EQ(points.lanes.diffuse_albedo(i), bsdf.diffuse_albedo()) << i;
    EXPECT_EQ(points.lanes.scatters_through(i), bsdf.scatters_through()) << i;
    EXPECT_EQ(points.lanes.normal(i), bsdf.normal()) << i;
  }
}

struct Drawn {
  int scattered = 0, mirrored = 0, refracted = 0, refracted_sharply = 0, none = 0;
};

void expect_samples_of(Points& points, Drawn& drawn) {
  Lanes lobe, u, v;
  for (int i = 0; i < kLanes; ++i) lobe[i] = points.between(0, 1), u[i] = points.between(0, 1), v[i] = points.between(0, 1);
  BsdfSampleLanes samples;
  points.lanes.sample(albedo(), lobe, u, v, samples);
  for (int i = 0; i < kLanes; ++i) {
    const MetalRoughBsdf bsdf = points.bsdf(i);
    const std::optional<BsdfSample> expected = bsdf.sample(lobe[i], {u[i], v[i]});
    ASSERT_EQ(samples.density[i] > 0.0f, expected.has_value()) << i;
    ++(!expected               ? drawn.none
       : expected->transmitted ? expected->is_delta() ? drawn.refracted_sharply : drawn.refracted
       : expected->is_delta()  ? drawn.mirrored
                               : drawn.scattered);
    if (!expected) continue;
    EXPECT_EQ(samples.direction.get(i), expected->direction) << i;
    EXPECT_EQ(samples.weight.get(i), expected->weight) << i;
    EXPECT_EQ(samples.density[i], expected->density) << i;
    EXPECT_EQ(samples.transmitted.lane[i] != 0, expected->transmitted) << i;
  }
}

TEST(MetalRoughLanes, values_equal_the_bsdfs) {
  for (const Kind kind : {Kind::kGloss, Kind::kAny})
    for (unsigned seed = 0; seed < 60; ++seed) {
      Points points(seed, kind);
      expect_values_of(points);
    }
}

TEST(MetalRoughLanes, samples_equal_the_bsdfs) {
  for (const Kind kind : {Kind::kGloss, Kind::kAny}) {
    Drawn drawn;
    for (unsigned seed = 0; seed < 100; ++seed) {
      Points points(seed, kind);
      expect_samples_of(points, drawn);
    }
    for (const int count : {drawn.scattered, drawn.mirrored, drawn.none}) EXPECT_GT(count, 100);
    for (const int count : {drawn.refracted, drawn.refracted_sharply})
      EXPECT_TRUE(kind == Kind::kAny ? count > 100 : count == 0);
  }
}

TEST(MetalRoughLanes, shortcut_without_gloss_is_exact) {
  Drawn drawn;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Points points(seed, Kind::kLambert);
    expect_values_of(points);
    expect_samples_of(points, drawn);
  }
  EXPECT_GT(drawn.scattered, 500);
  EXPECT_EQ(drawn.mirrored + drawn.refracted + drawn.refracted_sharply, 0);
}

TEST(MetalRoughLanes, lanes_are_independent) {
  Points points(1, Kind::kAny), glossy(1, Kind::kGloss), matt(1, Kind::kLambert);
  MetalRoughLanes lanes;
  lanes.clear();
  for (int i = 0; i < kLanes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Points& from = i % 2 == 1 ? points : i % 4 == 0 ? matt : glossy;
    lanes.set(i, from.surfaces[k], from.normals[k], from.views[k], Points::enters(i));
  }
  lanes.prepare(albedo());
  Lanes3 lights;
  for (int i = 0; i < kLanes; ++i) lights.set(i, points.normals[static_cast<std::size_t>(i)].diffuse);
  BsdfValueLanes mixed, all_matt, all_glossy;
  lanes.evaluate(albedo(), lights, mixed);
  matt.lanes.evaluate(albedo(), lights, all_matt);
  glossy.lanes.evaluate(albedo(), lights, all_glossy);
  for (int i = 0; i < kLanes; i += 2) {
    const BsdfValueLanes& alone = i % 4 == 0 ? all_matt : all_glossy;
    EXPECT_EQ(mixed.cosine_f.get(i), alone.cosine_f.get(i)) << i;
    EXPECT_EQ(mixed.density[i], alone.density[i]) << i;
  }
}

}  // namespace
}  // namespace lippmann
