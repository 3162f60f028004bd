#include "transport/microfacet.hpp"

#include <gtest/gtest.h>

#include "chi_squared.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

Vec3f view_from_z(float degrees_from_normal) {
  return {std::sin(radians(degrees_from_normal)), 0.0f, std::cos(radians(degrees_from_normal))};
}

TEST(Ggx, visible_facets_project_to_the_view) {
  // Let v be the direction to the viewer, h and n the normals of a facet and of the surface, G1 the visible part of
  // facets and D their density. The integral of G1(v) max(0, v . h) D(h) over h is v . n (Heitz 2014, equation 14), so
  // the density of visible facets integrates to one.
  for (const float alpha : {0.05f, 0.3f, 1.0f})
    for (const float angle : {0.0f, 40.0f, 80.0f}) {
      const Ggx ggx{alpha};
      double sum = 0.0;
      constexpr int kPolar = 2000, kAzimuth = 400;
      for (int p = 0; p < kPolar; ++p)
        for (int a = 0; a < kAzimuth; ++a) {
          // Narrow distributions peak at the normal, so polar angles are dense there: z = 1 - t^3.
          const double t = (p + 0.5) / kPolar, z = 1.0 - t * t * t, sine = std::sqrt(1.0 - z * z);
          const double turn = 2.0 * M_PI * (a + 0.5) / kAzimuth;
          const Vec3f h(static_cast<float>(sine * std::cos(turn)), static_cast<float>(sine * std::sin(turn)),
                        static_cast<float>(z));
          sum += static_cast<double>(ggx.visible_density(view_from_z(angle), h)) * 3.0 * t * t / kPolar * 2.0 * M_PI / kAzimuth;
        }
      EXPECT_NEAR(sum, 1.0, 2e-3) << "alpha " << alpha << ", " << angle << " degrees";
    }
}

TEST(Ggx, facets_follow_their_density) {
  for (const float alpha : {0.2f, 0.5f, 1.0f})
    for (const float angle : {0.0f, 45.0f, 75.0f}) {
      const Ggx ggx{alpha};
      const Vec3f view = view_from_z(angle);
      const auto draw = [&](int i) -> std::optional<Vec3f> {
        return ggx.sample_visible(view, scrambled_sobol(0, static_cast<std::uint32_t>(i)));
      };
      const auto density = [&](Vec3f h) { return h.z > 0.0f ? static_cast<double>(ggx.visible_density(view, h)) : 0.0; };
      EXPECT_LT(test::chi_squared(100'000, draw, density).deviations(), 4.0)
          << "alpha " << alpha << ", " << angle << " degrees";
    }
}

TEST(Fresnel, of_glass_is_known_at_three_angles) {
  // At normal incidence, the reflectance is ((1.5 - 1) / (1.5 + 1))^2 = 0.04.
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f), 0.04f, 1e-6f);
  // At Brewster's angle, whose tangent is 1.5, no parallel light is reflected. The reflectance is half of the
  // perpendicular part, ((1.5^2 - 1) / (1.5^2 + 1))^2 = 0.147929.
  EXPECT_NEAR(fresnel_dielectric(std::cos(std::atan(1.5f)), 1.5f), 0.5f * 0.147929f, 1e-5f);
  EXPECT_FLOAT_EQ(fresnel_dielectric(0.5f, 1.0f / 1.5f), 1.0f);  // total reflection, because sin 60 degrees x 1.5 > 1
}

}  // namespace
}  // namespace lippmann
