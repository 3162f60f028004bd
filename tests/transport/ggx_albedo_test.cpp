#include "transport/ggx_albedo.hpp"

#include <gtest/gtest.h>

#include "transport/microfacet.hpp"
#include "transport/tables.hpp"

namespace lippmann {
namespace {

using test::albedo;

/// The albedo of one scattering by quadrature over outgoing directions, F = 1.
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

TEST(GgxAlbedo, agrees_with_quadrature) {
  for (const float roughness : {0.5f, 0.75f, 1.0f})
    for (const float cosine : {0.15f, 0.5f, 0.97f}) {
      const Vec2f single = albedo().single(cosine, roughness * roughness);
      EXPECT_NEAR(single.x + single.y, brute_force(cosine, roughness * roughness), 0.004)  // linear between table entries
          << "roughness " << roughness << ", cosine " << cosine;
    }
}

TEST(GgxAlbedo, of_a_smooth_surface_is_fresnels) {
  const Vec2f single = albedo().single(0.5f, 0.0f);
  EXPECT_NEAR(single.x + single.y, 1.0f, 1e-3f);
  EXPECT_NEAR(single.y, 0.03125f, 2e-3f);  // (1 - 0.5)^5
}

TEST(GgxAlbedo, compensated_white_loses_nothing) {
  for (const float roughness : {0.1f, 0.6f, 1.0f})
    for (const float cosine : {0.05f, 0.4f, 1.0f}) {
      const Vec2f single = albedo().single(cosine, roughness * roughness);
      EXPECT_NEAR(GgxAlbedo::directional(single, Vec3f(1.0f), Vec3f(1.0f)).x, 1.0f, 1e-5f);
    }
}

TEST(GgxAlbedo, the_mean_is_that_of_the_directions) {
  const Vec3f f0(0.04f, 0.5f, 0.9f), f90(1.0f);
  constexpr int kPoints = 1000;
  Vec3f sum(0.0f);
  for (int i = 0; i < kPoints; ++i) {
    const float cosine = (static_cast<float>(i) + 0.5f) / kPoints;
    sum += 2.0f * cosine / kPoints * GgxAlbedo::directional(albedo().single(cosine, 0.36f), f0, f90);
  }
  const Vec3f mean = albedo().mean(0.36f, f0, f90);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], sum[c], 2e-3f) << "channel " << c;  // 0.6 lies between two entries
}

}  // namespace
}  // namespace lippmann
