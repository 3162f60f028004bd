#include <gtest/gtest.h>

#include "chi_squared.hpp"
#include "transport/metal_rough_bsdf.hpp"
#include "transport/phong_bsdf.hpp"
#include "transport/sampler.hpp"
#include "transport/tables.hpp"

namespace lippmann {
namespace {

using test::albedo;
using test::kNormal;

Vec3f view_at(float degrees_from_normal) {
  return Basis(kNormal).to_world({std::sin(radians(degrees_from_normal)), 0.0f, std::cos(radians(degrees_from_normal))});
}

MetalRoughBsdf bsdf_of(const MetalRoughSurface& surface, float angle, bool entering = true) {
  return {surface, albedo(), kNormal, kNormal, view_at(angle), entering};
}

std::vector<MetalRoughSurface> surfaces() {
  std::vector<MetalRoughSurface> all;
  for (const float roughness : {0.4f, 0.8f})
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
      MetalRoughSurface s;
      s.base_color = {0.9f, 0.5f, 0.2f};
      s.metallic = metallic, s.roughness = roughness;
      all.push_back(s);
    }
  MetalRoughSurface glass;
  glass.metallic = 0.0f, glass.roughness = 0.5f, glass.transmission = 0.7f;
  all.push_back(glass);
  MetalRoughSurface coated = all.front();
  coated.clearcoat = 0.8f, coated.clearcoat_roughness = 0.5f;
  all.push_back(coated);
  return all;
}

/// Returns the mean weight of `count` samples, and the mean of its square. A weight is the mean of three channels.
template <class Bsdf>
std::pair<double, double> mean_weight(const Bsdf& bsdf, int count) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(n, 1u).x, scrambled_sobol(n, 2u));
    const double w = s ? static_cast<double>(s->weight.x + s->weight.y + s->weight.z) / 3.0 : 0.0;
    sum += w, squares += w * w;
  }
  return {sum / count, squares / count};
}

TEST(MetalRoughBsdf, directions_follow_their_density) {
  int n = 0;
  for (const MetalRoughSurface& surface : surfaces())
    for (const float angle : {10.0f, 70.0f})
      for (const bool entering : {true, false}) {
        if (!entering && surface.transmission == 0.0f) continue;
        const MetalRoughBsdf bsdf = bsdf_of(surface, angle, entering);
        const auto draw = [&](int i) -> std::optional<Vec3f> {
          const auto seed = static_cast<std::uint32_t>(i);
          const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(0, ~seed).x, scrambled_sobol(0, seed));
          return s ? std::optional(s->direction) : std::nullopt;
        };
        const auto density = [&](Vec3f d) { return static_cast<double>(bsdf.evaluate(d).density); };
        EXPECT_LT(test::chi_squared(100'000, draw, density).deviations(), 4.0)
            << "surface " << n << " at " << angle << " degrees" << (entering ? "" : ", from inside");
        if (entering) ++n;
      }
}

TEST(MetalRoughBsdf, sample_agrees_with_evaluate) {
  for (const MetalRoughSurface& surface : surfaces()) {
    const MetalRoughBsdf bsdf = bsdf_of(surface, 40.0f);
    for (std::uint32_t i = 0; i < 50; ++i) {
      const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(i, 5u).x, scrambled_sobol(i, 6u));
      if (!s) continue;
      const BsdfValue value = bsdf.evaluate(s->direction);
      EXPECT_FLOAT_EQ(value.density, s->density);
      EXPECT_NEAR(value.cosine_f.y, s->weight.y * s->density, 1e-5f * s->density);
    }
  }
}

TEST(MetalRoughBsdf, white_furnace_conserves_energy) {
  for (const float metallic : {0.0f, 0.5f, 1.0f})
    for (int r = 0; r <= 10; ++r)
      for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f}) {
        MetalRoughSurface white;
        white.metallic = metallic, white.roughness = 0.1f * static_cast<float>(r);
        const auto [mean, squares] = mean_weight(bsdf_of(white, angle), 16'384);
        // The tolerance is 0.5 % for the tables of multiple scattering, plus three standard errors of the mean.
        EXPECT_NEAR(mean, 1.0, 0.005 + 3.0 * std::sqrt(std::max(0.0, squares - mean * mean) / 16'384))
            << "metallic " << metallic << ", roughness 0." << r << ", " << angle << " degrees";
      }
}

TEST(MetalRoughBsdf, smooth_glass_loses_nothing) {
  MetalRoughSurface glass;
  glass.metallic = 0.0f, glass.roughness = 0.0f, glass.transmission = 1.0f;
  for (const bool entering : {true, false}) EXPECT_NEAR(mean_weight(bsdf_of(glass, 50.0f, entering), 4096).first, 1.0, 1e-4);
}

// The tolerance of 1 % covers interpolation in the tables and noise.
TEST(MetalRoughBsdf, rough_glass_conserves_energy) {
  for (const float ior : {1.33f, 1.5f, 2.0f})
    for (int r = 1; r <= 10; ++r)
      for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f})
        for (const bool entering : {true, false}) {
          MetalRoughSurface glass;
          glass.metallic = 0.0f, glass.transmission = 1.0f;
          glass.roughness = 0.1f * static_cast<float>(r), glass.ior = ior;
          const auto [mean, squares] = mean_weight(bsdf_of(glass, angle, entering), 16'384);
          EXPECT_NEAR(mean, 1.0, 0.01 + 3.0 * std::sqrt(std::max(0.0, squares - mean * mean) / 16'384))
              << "ior " << ior << ", roughness " << r << " / 10, " << angle << " degrees" << (entering ? "" : ", from inside");
        }
}

TEST(MetalRoughBsdf, glass_follows_fresnel_and_snell) {
  MetalRoughSurface glass;
  glass.metallic = 0.0f, glass.roughness = 0.0f, glass.transmission = 1.0f, glass.ior = 1.5f;
  const MetalRoughBsdf bsdf = bsdf_of(glass, 0.0f);
  EXPECT_FALSE(bsdf.sample(0.039f, Vec2f(0.5f))->transmitted);  // glass of index 1.5 reflects 4 % at normal incidence
  EXPECT_TRUE(bsdf.sample(0.041f, Vec2f(0.5f))->transmitted);
  const std::optional<BsdfSample> bent = bsdf_of(glass, 30.0f).sample(0.9f, Vec2f(0.5f));
  EXPECT_NEAR(glm::length(glm::cross(bent->direction, kNormal)), 0.5f / 1.5f, 1e-5f);
}

TEST(MetalRoughBsdf, is_reciprocal_as_documented) {
  MetalRoughSurface diffuse;
  diffuse.metallic = 0.0f, diffuse.roughness = 0.6f, diffuse.base_color = {0.8f, 0.4f, 0.2f};
  const Vec3f a = view_at(20.0f), b = view_at(65.0f);
  const Vec3f ab = MetalRoughBsdf(diffuse, albedo(), kNormal, kNormal, a, true).evaluate(b).cosine_f / glm::dot(b, kNormal);
  const Vec3f ba = MetalRoughBsdf(diffuse, albedo(), kNormal, kNormal, b, true).evaluate(a).cosine_f / glm::dot(a, kNormal);
  // The compensation for multiple scattering depends only on the direction to the viewer. For a reflectance of 0.04,
  // exchanging both directions changes the result by a few thousandths.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ab[c], ba[c], 3e-3f * ab[c]);
}

TEST(MetalRoughBsdf, black_metal_reflects_only_at_grazing_angles) {
  MetalRoughSurface black;
  black.base_color = Vec3f(0.0f), black.metallic = 1.0f, black.roughness = 0.0f;
  EXPECT_NEAR(mean_weight(bsdf_of(black, 0.0f), 256).first, 0.0, 1e-6);
}

TEST(PhongBsdf, diffuse_white_conserves_energy) {
  PhongPoint white;
  white.diffuse = Vec3f(1.0f);
  const PhongBsdf bsdf(white, kNormal, view_at(30.0f), true);
  EXPECT_NEAR(mean_weight(bsdf, 1024).first, 1.0, 1e-5);
  const auto draw = [&](int i) -> std::optional<Vec3f> {
    return bsdf.sample(0.3f, scrambled_sobol(0, static_cast<std::uint32_t>(i)))->direction;
  };
  EXPECT_LT(
      test::chi_squared(100'000, draw, [&](Vec3f d) { return static_cast<double>(bsdf.evaluate(d).density); }).deviations(),
      4.0);
}

TEST(PhongBsdf, each_part_gets_its_share) {
  PhongPoint point;
  point.diffuse = Vec3f(0.5f), point.mirror = Vec3f(0.25f), point.through = 0.25f;
  const PhongBsdf bsdf(point, kNormal, view_at(30.0f), true);
  EXPECT_FALSE(bsdf.sample(0.49f, Vec2f(0.5f))->is_delta());
  const BsdfSample mirror = *bsdf.sample(0.6f, Vec2f(0.5f)), through = *bsdf.sample(0.8f, Vec2f(0.5f));
  EXPECT_NEAR(glm::dot(mirror.direction, view_at(-30.0f)), 1.0f, 1e-5f);
  EXPECT_NEAR(mirror.weight.x, 1.0f, 1e-5f);
  EXPECT_TRUE(through.transmitted);
  EXPECT_NEAR(glm::dot(through.direction, view_at(30.0f)), -1.0f, 1e-5f);
}

TEST(PhongBsdf, the_highlight_is_blinns) {
  PhongPoint point;
  point.highlight = Vec3f(0.5f), point.highlight_size = 10.0f;
  const PhongBsdf bsdf(point, kNormal, view_at(30.0f), true);
  EXPECT_NEAR(bsdf.highlight(view_at(-30.0f)).x, 0.5f / kPi, 1e-5f);
  EXPECT_NEAR(bsdf.highlight(view_at(-10.0f)).x, 0.5f * std::pow(std::cos(radians(10.0f)), 10.0f) / kPi, 1e-5f);
}

}  // namespace
}  // namespace lippmann
