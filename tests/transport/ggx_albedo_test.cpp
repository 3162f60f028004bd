#include "transport/ggx_albedo.hpp"

#include <gtest/gtest.h>

#include "facet_walk.hpp"
#include "transport/microfacet.hpp"
#include "transport/tables.hpp"

namespace lippmann {
namespace {

using test::albedo;
using test::walked_albedo;

/// Albedo of single scattering for F = 1, by quadrature over outgoing directions.
double brute_force(float cosine, float alpha) {
  const Ggx ggx{alpha};
  const Vec3f view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  double sum = 0.0;
  constexpr int kPolar = 800, kAzimuth = 800;
  for (int p = 0; p < kPolar; ++p)
    for (int a = 0; a < kAzimuth; ++a) {
      const double z = (p + 0.5) / kPolar, sine = std::sqrt(1.0 - z * z), turn = 2.0 * M_PI * (a + 0.5) / kAzimuth;
      const Vec3f light(static_cast<float>(sine * std::cos(turn)), static_cast<float>(sine * std::sin(turn)),
                        static_cast<float>(z));
      const Vec3f h = glm::normalize(view + light);
      sum += static_cast<double>(ggx.distribution(h) * ggx.masking(view, light) / (4.0f * view.z)) / kPolar * 2.0 * M_PI /
             kAzimuth;
    }
  return sum;
}

// The tolerance of 2 % covers the fit's error of 1.2 % and the noise of the random walks. If every reflection after the
// first had the mean reflectance, metals of roughness 0.3 to 0.6 would be 4 to 6 % too dark at cosines of 0.1 and 0.2.
TEST(GgxAlbedo, of_coloured_metals_matches_facet_walks) {
  const Vec3f f0(0.2f, 0.5f, 0.8f);
  for (const float roughness : {0.3f, 0.45f, 0.6f, 0.8f, 1.0f})
    for (const float cosine : {0.1f, 0.2f, 0.3f, 0.7f, 0.999f}) {
      const float alpha = roughness * roughness;
      const Vec3f walked = walked_albedo({std::sqrt(1.0f - cosine * cosine), 0.0f, cosine}, Vec2f(alpha), f0);
      const Vec3f ours = GgxAlbedo::directional(albedo().single(cosine, alpha), f0, Vec3f(1.0f));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(ours[c], walked[c], 0.02f * walked[c])
            << "roughness " << roughness << ", cosine " << cosine << ", F0 " << f0[c];
    }
}

TEST(GgxAlbedo, of_a_white_walk_is_one) {
  EXPECT_NEAR(walked_albedo({0.6f, 0.0f, 0.8f}, Vec2f(1.0f), Vec3f(1.0f)).x, 1.0f, 1e-6f);
}

TEST(GgxAlbedo, agrees_with_quadrature) {
  for (const float roughness : {0.5f, 0.75f, 1.0f})
    for (const float cosine : {0.15f, 0.5f, 0.97f}) {
      const Vec3f single = albedo().single(cosine, roughness * roughness);
      // The tolerance covers linear interpolation in the table.
      EXPECT_NEAR(single.x + single.y, brute_force(cosine, roughness * roughness), 0.004)
          << "roughness " << roughness << ", cosine " << cosine;
    }
}

TEST(GgxAlbedo, of_smooth_surfaces_is_fresnels) {
  const Vec3f single = albedo().single(0.5f, 0.0f);
  EXPECT_NEAR(single.x + single.y, 1.0f, 1e-3f);
  EXPECT_NEAR(single.y, 0.03125f, 2e-3f);  // Schlick's weight (1 - 0.5)^5
}

TEST(GgxAlbedo, compensated_white_conserves_energy) {
  for (const float roughness : {0.1f, 0.6f, 1.0f})
    for (const float cosine : {0.05f, 0.4f, 1.0f}) {
      const Vec3f single = albedo().single(cosine, roughness * roughness);
      EXPECT_NEAR(GgxAlbedo::directional(single, Vec3f(1.0f), Vec3f(1.0f)).x, 1.0f, 1e-5f);
    }
}

TEST(GgxAlbedo, mean_equals_the_directions_mean) {
  const Vec3f f0(0.04f, 0.5f, 0.9f), f90(1.0f);
  constexpr int kPoints = 1000;
  Vec3f sum(0.0f);
  for (int i = 0; i < kPoints; ++i) {
    const float cosine = (static_cast<float>(i) + 0.5f) / kPoints;
    sum += 2.0f * cosine / kPoints * GgxAlbedo::directional(albedo().single(cosine, 0.36f), f0, f90);
  }
  const Vec3f mean = albedo().mean(0.36f, f0, f90);
  // The tolerance covers interpolation, because roughness 0.6 is between two entries of the table.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], sum[c], 2e-3f) << "channel " << c;
}

}  // namespace
}  // namespace lippmann
