#include <gtest/gtest.h>

#include "chi_squared.hpp"
#include "facet_walk.hpp"
#include "transport/layered_bsdf.hpp"
#include "transport/sampler.hpp"
#include "transport/tables.hpp"

namespace lippmann {
namespace {

using test::albedo;
using test::kNormal;
const Basis kBasis(kNormal);
const Vec3f kTangent = kBasis.to_world({0.6f, 0.8f, 0.0f});

Vec3f direction(float degrees_from_normal, float azimuth_degrees = 0.0f) {
  const float sine = std::sin(radians(degrees_from_normal)), azimuth = radians(azimuth_degrees);
  return kBasis.to_world({sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(radians(degrees_from_normal))});
}

LayeredBsdf bsdf_of(const LayeredSurface& surface, Vec3f view, bool entering = true) {
  return {surface, albedo(), {kNormal, kNormal, kNormal}, kTangent, view, entering};
}

/// Different normals of the diffuse part, the gloss and the coat. A view of up to 50 degrees from kNormal is less than
/// 90 degrees from each of the three normals.
const MetalRoughBsdf::Normals kApart{kNormal, direction(30.0f, 20.0f), direction(35.0f, 200.0f)};

LayeredSurface dielectric(float roughness) {
  LayeredSurface s;
  s.base.metallic = 0.0f, s.base.roughness = roughness, s.base.base_color = {0.8f, 0.4f, 0.2f};
  return s;
}

LayeredSurface sheen(float roughness) {
  LayeredSurface s = dielectric(0.8f);
  s.sheen_color = {0.9f, 0.7f, 0.5f}, s.sheen_roughness = roughness;
  return s;
}

LayeredSurface brushed(float roughness, float anisotropy) {
  LayeredSurface s = dielectric(roughness);
  s.base.metallic = 1.0f, s.anisotropy = anisotropy;
  return s;
}

LayeredSurface filmed(float metallic) {
  LayeredSurface s = dielectric(0.5f);
  s.base.metallic = metallic;
  s.film_share = 1.0f, s.film = {1.5f, 480.0f};
  return s;
}

LayeredSurface leaf() {
  LayeredSurface s = dielectric(0.6f);
  s.diffuse_transmission = 0.6f, s.diffuse_transmission_color = {0.3f, 0.8f, 0.2f};
  return s;
}

LayeredSurface pane(float roughness) {
  LayeredSurface s = dielectric(roughness);
  s.base.transmission = 1.0f, s.is_thin = true;
  return s;
}

struct Case {
  const char* name;
  LayeredSurface surface;
};

std::vector<Case> rough_surfaces() {
  LayeredSurface all = sheen(0.4f);
  all.base.transmission = 0.5f, all.base.clearcoat = 0.7f, all.base.clearcoat_roughness = 0.5f;
  all.anisotropy = 0.5f, all.film_share = 0.5f, all.diffuse_transmission = 0.4f;
  LayeredSurface brushed_glass = pane(0.4f);
  brushed_glass.is_thin = false, brushed_glass.anisotropy = 0.6f;
  return {{"soft sheen", sheen(0.9f)},
          {"thin sheen", sheen(0.3f)},
          {"brushed", brushed(0.5f, 0.7f)},
          {"brushed dielectric", brushed(0.6f, 0.5f)},
          {"film on plastic", filmed(0.0f)},
          {"film on metal", filmed(1.0f)},
          {"leaf", leaf()},
          {"pane", pane(0.5f)},
          {"brushed glass", brushed_glass},
          {"all", all}};
}

struct Furnace {
  Vec3f mean;
  float chance;
};
Furnace furnace(const LayeredBsdf& bsdf, int count = 8'192) {
  glm::dvec3 sum(0.0);
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(n, 1u).x, scrambled_sobol(n, 2u));
    if (!s) continue;
    sum += glm::dvec3(s->weight);
    squares += static_cast<double>(s->weight.y) * static_cast<double>(s->weight.y);
  }
  const glm::dvec3 mean = sum / static_cast<double>(count);
  return {Vec3f(mean), static_cast<float>(3.0 * std::sqrt(std::max(0.0, squares / count - mean.y * mean.y) / count))};
}

double deviations(const LayeredBsdf& bsdf) {
  const auto draw = [&](int i) -> std::optional<Vec3f> {
    const auto seed = static_cast<std::uint32_t>(i);
    const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(0, ~seed).x, scrambled_sobol(0, seed));
    return s ? std::optional(s->direction) : std::nullopt;
  };
  const auto density = [&](Vec3f d) { return static_cast<double>(bsdf.evaluate(d).density); };
  return test::chi_squared(100'000, draw, density).deviations();
}

TEST(LayeredBsdf, directions_follow_their_density) {
  for (const Case& c : rough_surfaces())
    for (const float angle : {10.0f, 70.0f})
      for (const bool entering : {true, false})
        EXPECT_LT(deviations(bsdf_of(c.surface, direction(angle, 30.0f), entering)), 4.0)
            << c.name << " at " << angle << " degrees" << (entering ? "" : ", from inside");
}

TEST(LayeredBsdf, three_normals_follow_their_density) {
  for (const Case& c : rough_surfaces())
    for (const float angle : {10.0f, 50.0f})
      EXPECT_LT(deviations(LayeredBsdf(c.surface, albedo(), kApart, kTangent, direction(angle, 100.0f), true)), 4.0)
          << c.name << " at " << angle << " degrees";
}

TEST(LayeredBsdf, sample_agrees_with_evaluate) {
  for (const Case& c : rough_surfaces()) {
    const LayeredBsdf bsdf = bsdf_of(c.surface, direction(40.0f));
    for (std::uint32_t i = 0; i < 50; ++i) {
      const std::optional<BsdfSample> s = bsdf.sample(scrambled_sobol(i, 5u).x, scrambled_sobol(i, 6u));
      if (!s) continue;
      const BsdfValue value = bsdf.evaluate(s->direction);
      EXPECT_FLOAT_EQ(value.density, s->density) << c.name;
      EXPECT_NEAR(value.cosine_f.y, s->weight.y * s->density, 1e-5f * s->density) << c.name;
      EXPECT_EQ(s->transmitted, value.transmitted) << c.name;
    }
  }
}

// The film's compensation for multiple scattering depends only on the direction to the viewer, which changes results by
// a few thousandths.
TEST(LayeredBsdf, sheen_film_and_diffuse_transmission_are_reciprocal) {
  for (LayeredSurface s : {sheen(0.3f), sheen(1.0f), filmed(0.0f), leaf()}) {
    s.base.specular = 0.0f;
    const Vec3f a = direction(20.0f), b = direction(65.0f, 110.0f), c = -direction(50.0f, 200.0f);
    for (const Vec3f light : {b, c}) {
      const Vec3f front = light == b ? kNormal : -kNormal;
      const Vec3f to_a = bsdf_of(s, a).evaluate(light).cosine_f / glm::dot(light, front);
      const Vec3f to_light = LayeredBsdf(s, albedo(), {front, front, front}, kTangent, light, light == b).evaluate(a).cosine_f /
                             glm::dot(a, kNormal);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(to_a[k], to_light[k], 3e-3f * to_a[k] + 1e-6f);
    }
  }
}

// The compensation for multiple scattering depends only on the direction to the viewer. Smooth metal needs little
// compensation.
TEST(LayeredBsdf, smooth_brushed_metal_is_reciprocal) {
  const LayeredSurface s = brushed(0.15f, 0.2f);
  const Vec3f a = direction(25.0f, 10.0f), b = direction(30.0f, 185.0f);
  const Vec3f ab = bsdf_of(s, a).evaluate(b).cosine_f / glm::dot(b, kNormal);
  const Vec3f ba = bsdf_of(s, b).evaluate(a).cosine_f / glm::dot(a, kNormal);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ab[c], ba[c], 2e-3f * ab[c]);
}

TEST(LayeredBsdf, without_layers_equals_the_base_surface) {
  LayeredSurface coated = dielectric(0.5f);
  coated.base.metallic = 0.3f, coated.base.transmission = 0.4f, coated.base.clearcoat = 0.6f;
  coated.base.clearcoat_roughness = 0.4f;
  const MetalRoughBsdf::Normals alike{kNormal, kNormal, kNormal};
  for (const LayeredSurface& s : {dielectric(0.4f), dielectric(0.0f), coated})
    for (const MetalRoughBsdf::Normals& normals : {alike, kApart}) {
      const Vec3f view = direction(35.0f);
      const MetalRoughBsdf common(s.base, albedo(), normals, view, true);
      const LayeredBsdf layered(s, albedo(), normals, kTangent, view, true);
      EXPECT_EQ(layered.normal(), common.normal());
      for (const Vec3f light : {direction(50.0f, 170.0f), direction(10.0f, 60.0f), direction(80.0f, 200.0f),
                                direction(100.0f, 200.0f), direction(100.0f, 20.0f), -direction(30.0f, 180.0f)}) {
        const BsdfValue ours = layered.evaluate(light), theirs = common.evaluate(light);
        EXPECT_NEAR(ours.density, theirs.density, 1e-4f * theirs.density);
        EXPECT_EQ(ours.transmitted, theirs.transmitted);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(ours.cosine_f[c], theirs.cosine_f[c], 1e-4f * theirs.cosine_f[c]);
        const Vec3f matt = layered.evaluate_diffuse(light), common_matt = common.evaluate_diffuse(light);
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(layered.diffuse_albedo()[c] * matt[c], common.diffuse_albedo()[c] * common_matt[c],
                      1e-4f * common.diffuse_albedo()[c]);
      }
    }
}

// The tolerance of 3 % covers interpolation in the table.
TEST(LayeredBsdf, white_brushed_metal_conserves_energy) {
  for (const float roughness : {0.1f, 0.3f, 0.6f, 0.9f})
    for (const float anisotropy : {0.3f, 0.6f, 1.0f})
      for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f})
        for (const float azimuth : {0.0f, 53.13f, 143.13f}) {
          LayeredSurface s = brushed(roughness, anisotropy);
          s.base.base_color = Vec3f(1.0f);
          const Furnace f = furnace(bsdf_of(s, direction(angle, azimuth)));
          EXPECT_NEAR(f.mean.y, 1.0f, 0.03f + f.chance)
              << "roughness " << roughness << ", anisotropy " << anisotropy << ", at " << angle << ", " << azimuth;
        }
}

// The tolerance of 7 % covers interpolation in the table, and the assumption that all facets after the first have the
// roughness that the viewer sees.
TEST(LayeredBsdf, coloured_brushed_metal_matches_facet_walks) {
  for (const float roughness : {0.2f, 0.4f})
    for (const float cosine : {0.1f, 0.3f})
      for (const float azimuth : {0.0f, 1.57f}) {
        LayeredSurface s = brushed(roughness, 0.6f);
        s.base.base_color = {0.2f, 0.5f, 0.8f};
        const float sine = std::sqrt(1.0f - cosine * cosine);
        const Vec3f view(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
        const Vec3f x = kTangent, y = glm::cross(kNormal, x);
        const Furnace f = furnace(bsdf_of(s, view.x * x + view.y * y + view.z * kNormal));
        const float across = squared(roughness), along = glm::mix(across, 1.0f, squared(s.anisotropy));
        const Vec3f walked = test::walked_albedo(view, {along, across}, s.base.base_color);
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(f.mean[c], walked[c], 0.07f * walked[c])
              << "roughness " << roughness << ", cosine " << cosine << ", azimuth " << azimuth << ", channel " << c;
      }
}

TEST(LayeredBsdf, white_panes_and_leaves_conserve_energy) {
  for (int r = 0; r <= 10; ++r)
    for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f}) {
      LayeredSurface glass = pane(0.1f * static_cast<float>(r)), both = leaf();
      glass.base.base_color = both.base.base_color = both.diffuse_transmission_color = Vec3f(1.0f);
      both.base.roughness = glass.base.roughness;
      for (const LayeredSurface& s : {glass, both}) {
        const Furnace f = furnace(bsdf_of(s, direction(angle)));
        EXPECT_NEAR(f.mean.y, 1.0f, 0.005f + f.chance) << "roughness " << r << " / 10 at " << angle << " degrees";
      }
    }
}

// Sheen and films transmit the smaller of the shares for the viewer's and the light's direction, so they may lose light
// but never add any. A film's reflectance is computed at one angle for the whole surface, for which the test allows 1
// %.
TEST(LayeredBsdf, white_sheen_and_films_add_no_light) {
  for (int r = 1; r <= 10; ++r)
    for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f})
      for (const float thickness : {0.0f, 150.0f, 400.0f, 900.0f}) {
        LayeredSurface s = dielectric(0.1f * static_cast<float>(r));
        s.base.base_color = Vec3f(1.0f);
        if (thickness == 0.0f)
          s.sheen_color = Vec3f(1.0f), s.sheen_roughness = s.base.roughness;
        else
          s.film_share = 1.0f, s.film = {1.4f, thickness};
        const Furnace f = furnace(bsdf_of(s, direction(angle)));
        for (int c = 0; c < 3; ++c)
          EXPECT_LT(f.mean[c], 1.01f + f.chance) << "roughness " << r << " / 10, " << angle << " degrees, " << thickness;
        EXPECT_GT(f.mean.y, 0.6f) << "roughness " << r << " / 10, " << angle << " degrees, " << thickness;
      }
}

TEST(LayeredBsdf, black_cloth_shows_the_sheens_albedo) {
  LayeredSurface s = sheen(0.5f);
  s.base.base_color = Vec3f(0.0f), s.base.specular = 0.0f, s.sheen_color = Vec3f(1.0f);
  for (const float angle : {0.0f, 45.0f, 75.0f}) {
    const Furnace f = furnace(bsdf_of(s, direction(angle)));
    EXPECT_NEAR(f.mean.y, albedo().sheen()(std::cos(radians(angle)), 0.5f), 0.005f + f.chance) << angle;
  }
}

TEST(LayeredBsdf, smooth_panes_follow_fresnel_without_bending) {
  const LayeredBsdf bsdf = bsdf_of(pane(0.0f), direction(30.0f));
  const std::optional<BsdfSample> through = bsdf.sample(0.9f, Vec2f(0.5f)), back = bsdf.sample(0.001f, Vec2f(0.5f));
  EXPECT_TRUE(through->transmitted && through->is_delta());
  EXPECT_NEAR(glm::dot(through->direction, -direction(30.0f)), 1.0f, 1e-5f);
  EXPECT_NEAR(through->weight.x, 0.8f, 1e-5f);  // red of the tint
  EXPECT_FALSE(back->transmitted);
  EXPECT_NEAR(back->weight.x, 1.0f, 1e-5f);
}

TEST(LayeredBsdf, brushed_metal_is_wider_along_the_tangent) {
  const LayeredBsdf bsdf = bsdf_of(brushed(0.2f, 0.8f), kNormal);
  const Vec3f bitangent = glm::cross(kNormal, kTangent);
  const auto leaning = [&](Vec3f towards) { return bsdf.evaluate(glm::normalize(kNormal + 0.5f * towards)).cosine_f.x; };
  EXPECT_GT(leaning(kTangent), 10.0f * leaning(bitangent));
  EXPECT_FLOAT_EQ(leaning(kTangent), leaning(-kTangent));
}

// A film of thickness 0 has no front boundary. The tolerance of 0.02 covers the Gaussian fit for white.
TEST(ThinFilm, of_zero_thickness_has_no_effect) {
  for (const float cosine : {1.0f, 0.7f, 0.5f, 0.2f}) {
    const float bare = 0.04f + 0.96f * schlick_weight(cosine);
    const Vec3f f = film_reflectance({1.8f, 0.0f}, Vec3f(0.04f), cosine);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], bare, 0.02f + 0.1f * bare) << cosine;
  }
}

TEST(ThinFilm, is_finite_and_adds_no_light) {
  for (const float ior : {1.0f, 1.3f, 3.0f, 1000.0f})
    for (const float thickness : {0.0f, 1.0f, 550.0f, 1e6f})
      for (const float f0 : {0.0f, 0.04f, 1.0f})
        for (const float cosine : {0.0f, 0.3f, 1.0f})
          for (int c = 0; c < 3; ++c) {
            const Vec3f f = film_reflectance({ior, thickness}, Vec3f(f0), cosine);
            EXPECT_TRUE(f[c] >= 0.0f && f[c] <= 1.0f) << ior << " " << thickness << " " << f0 << " " << cosine;
          }
}

// The film's index n is between air and glass, and 2 n d = lambda / 2 for the thickness d, so the reflections at both
// sides cancel.
TEST(ThinFilm, quarter_wave_coating_reduces_reflection) {
  const Vec3f coated = film_reflectance({1.22f, 550.0f / 4.0f / 1.22f}, Vec3f(0.04f), 1.0f);
  EXPECT_LT(coated.y, 0.02f);
}

// At 60 degrees, glass of index 1.5 reflects 0.08919 by Fresnel's equations (thin_walls_test.cpp), and the coat 0.04 + 0.96 x
// 0.5^5 by Schlick's approximation.
TEST(LayeredBsdf, thin_walls_pass_the_remaining_light) {
  const Vec3f view = direction(60.0f);
  LayeredSurface wall = pane(0.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(bsdf_of(wall, view).straight()[c], 0.91081f * wall.base.base_color[c], 1e-4f);
  wall.base.transmission = 0.5f, wall.base.clearcoat = 1.0f;
  const float below = 1.0f - (0.04f + 0.96f / 32.0f);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(bsdf_of(wall, view).straight()[c], 0.5f * below * 0.91081f * wall.base.base_color[c], 1e-3f);
  EXPECT_EQ(bsdf_of(pane(0.04f), view).straight(), Vec3f(0.0f));
  EXPECT_EQ(bsdf_of(dielectric(0.0f), view).straight(), Vec3f(0.0f));
  EXPECT_EQ(bsdf_of(leaf(), view).straight(), Vec3f(0.0f));
}

// Compares straight() with the mean weight of samples for evenly spaced numbers. The tolerance covers the spacing of
// the numbers.
TEST(LayeredBsdf, samples_pass_thin_walls_with_that_mean) {
  LayeredSurface wall = pane(0.0f);
  wall.base.transmission = 0.7f, wall.base.clearcoat = 0.5f, wall.sheen_color = Vec3f(0.3f), wall.sheen_roughness = 0.5f;
  wall.film_share = 0.5f, wall.film = {1.5f, 480.0f};
  for (const bool known : {false, true}) {
    wall.shadow_rays_pass = known;
    const Vec3f view = direction(35.0f);
    const LayeredBsdf bsdf = bsdf_of(wall, view);
    Vec3f sum(0.0f);
    constexpr int kNumbers = 65536;
    for (int k = 0; k < kNumbers; ++k) {
      const std::optional<BsdfSample> s = bsdf.sample((static_cast<float>(k) + 0.5f) / kNumbers, Vec2f(0.5f));
      if (!s || !s->transmitted) continue;
      sum += s->weight;
      EXPECT_TRUE(s->is_delta());
      EXPECT_EQ(s->direction, -view);
      EXPECT_EQ(s->straight, known);
      EXPECT_EQ(s->is_vertex, !known);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / kNumbers, bsdf.straight()[c], 4e-4f);
  }
}

}  // namespace
}  // namespace lippmann
