#include <gtest/gtest.h>

#include <cmath>

#include "scene/photometric_web.hpp"
#include "shading/shaded_scene.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// The eye at (0, 0, 1) sees the square from -0.2 to 0.2 in x and y at z = 0.
const Affine3f kEyeBelowWeb{Mat3f(0.1f), Vec3f(0.0f)};
constexpr float kWebHeight = 2.0f;

/// Returns the intensity cos^n a, divided by its mean over the sphere. a is the angle to -z. Beyond 90 degrees, the
/// intensity is 0.
PhotometricWeb cosine_web(double n) {
  PhotometricWeb web;
  for (int step = 0; step <= 180; ++step) {
    web.polar.push_back(static_cast<float>(step * M_PI / 360.0));
    web.intensity.push_back(static_cast<float>(std::pow(std::max(std::cos(step * M_PI / 360.0), 0.0), n)));
  }
  web.azimuth = {0.0f};
  web.web_from_light = Mat3f({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  const double mean = mean_intensity(web);
  for (float& i : web.intensity) i = static_cast<float>(static_cast<double>(i) / mean);
  return web;
}

/// The mean of cos^n a over the sphere is 1 / (2 (n + 1)).
double cosine_peak(double n) { return 2.0 * (n + 1.0); }

MetallicRoughness white_floor() {
  MetallicRoughness m;
  m.metallic = 0.0f, m.roughness = 1.0f, m.specular = 0.0f;
  return m;
}

/// `color` is the lamp's radiant intensity. The lamp points down, tilted by `tilt` radians towards +x.
SmallScene below_lamp(Vec3f color, float tilt) {
  SmallScene s;
  s.add(square(2, 0), s.material(white_floor()));
  Light& lamp = s.point_light({-kWebHeight * std::tan(tilt), 0.0f, kWebHeight}, color);
  lamp.inverse_square = true;
  s.scene.nodes.back().matrix->linear = glm::mat3_cast(glm::angleAxis(-tilt, Vec3f(0.0f, 1.0f, 0.0f)));
  return s;
}

Image web_picture(const Scene& scene, int spp, Integrator integrator = Integrator::kPath) {
  TraceParams params;
  params.spp = spp;
  return trace(scene, single_view(16), params, 1, 0.0, kEyeBelowWeb, integrator).film;
}

void expect_same_light(const Image& a, const Image& b, float tolerance) {
  ASSERT_GT(mean(b), 0.01);
  for (std::size_t i = 0; i < a.data.size(); ++i) ASSERT_NEAR(a.data[i], b.data[i], tolerance * b.data[i]) << i;
}

// A spot with an inner cone of 0 and an outer cone of 90 degrees falls off with the squared cosine.
TEST(PhotometricWeb, squared_cosine_matches_a_spot) {
  for (const float tilt : {0.0f, 0.6f})
    for (const Integrator integrator : {Integrator::kPath, Integrator::kWhitted}) {
      SmallScene web = below_lamp(Vec3f(1.0f), tilt), spot = below_lamp(Vec3f(static_cast<float>(cosine_peak(2))), tilt);
      web.scene.webs.push_back(cosine_web(2));
      web.scene.lights[0].web = 0;
      spot.scene.lights[0].kind = LightKind::kSpot;
      spot.scene.lights[0].inner_cone = 0.0f, spot.scene.lights[0].outer_cone = 0.5f * kPi;
      expect_same_light(web_picture(web.scene, 4, integrator), web_picture(spot.scene, 4, integrator), 2e-4f);
    }
}

// Radiance of the white floor straight below: intensity / (pi distance^2), with distance 2.
TEST(PhotometricWeb, light_below_is_peak_over_squared_distance) {
  for (const double n : {1.0, 8.0, 40.0}) {
    SmallScene s = below_lamp(Vec3f(1.0f), 0.0f);
    s.scene.webs.push_back(cosine_web(n));
    s.scene.lights[0].web = 0;
    const Image film = web_picture(s.scene, 16);
    const double expected = cosine_peak(n) / (M_PI * 4.0);
    EXPECT_NEAR(static_cast<double>(film.pixel(8, 8)[0]), expected, 0.01 * expected) << n;
  }
}

// The lamp's flux is 4 pi, so the mean irradiance on a sphere of radius 1 around it is 1.
TEST(PhotometricWeb, flux_equals_an_isotropic_lamps) {
  SmallScene s = below_lamp(Vec3f(1.0f), 0.3f);
  s.scene.webs.push_back(cosine_web(5));
  s.scene.lights[0].web = 0;
  const ThreadPool pool(1);
  const DeviceScene device(s.scene, pool, Integrator::kPath);
  const LightTable& lights = *device.shaded().path->lights;
  const Vec3f middle = device.shaded().lights[0].position;
  double sum = 0.0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double z = (i + 0.5) * 2.0 / kSteps - 1.0, r = std::sqrt(1.0 - z * z), a = (j + 0.5) * 2.0 * M_PI / kSteps;
      const auto light = lights.sample({middle + Vec3f(r * std::cos(a), r * std::sin(a), z)}, 0.5f, Vec2f(0.5f));
      if (light) sum += static_cast<double>(light->radiance.x);
    }
  EXPECT_NEAR(sum / (kSteps * kSteps), 1.0, 2e-3);
}

TEST(PhotometricWeb, many_webs_are_sampled_without_bias) {
  for (const float radius : {0.0f, 0.1f}) {
    const auto lamps = [&](int first, int end) {
      SmallScene s;
      s.add(square(2, 0), s.material(white_floor()));
      for (const double n : {2.0, 12.0}) s.scene.webs.push_back(cosine_web(n));
      for (int l = first; l < end; ++l) {
        const float angle = 2.4f * static_cast<float>(l), r = 1.8f * std::sqrt(static_cast<float>(l) / 40.0f);
        Light& lamp = s.point_light({r * std::cos(angle), r * std::sin(angle), 1.5f}, Vec3f(l % 3 == 0 ? 2.0f : 0.2f));
        lamp.inverse_square = true, lamp.radius = radius, lamp.web = l % 2;
        s.scene.nodes.back().matrix->linear =
            glm::mat3_cast(glm::angleAxis(0.05f * static_cast<float>(l), glm::normalize(Vec3f(std::sin(angle), 1.0f, 0.1f))));
      }
      return s.scene;
    };
    double sum = 0.0;
    for (int l = 0; l < 40; ++l) sum += mean(web_picture(lamps(l, l + 1), 64));
    EXPECT_GT(sum, 0.01);
    EXPECT_NEAR(mean(web_picture(lamps(0, 40), 1024)), sum, 0.015 * sum) << radius;
  }
}

TEST(WebBeam, beam_summarises_the_web) {
  const std::vector<PhotometricWeb> webs{cosine_web(2)};
  const WebBeam beam = beams_of(webs)[0];
  EXPECT_NEAR(beam.axis.z, -1.0f, 1e-4f);
  EXPECT_GE(beam.half_angle, 0.5f * kPi - 0.06f);
  EXPECT_LT(beam.half_angle, 0.5f * kPi + 0.2f);
  // The coefficient of Legendre polynomial P_k is (2 k + 1) / 2 times the integral of 6 c^2 P_k(c) over the cosine c from 0 to
  // 1, with P_0 = 1, P_1 = c and P_2 = (3 c^2 - 1) / 2.
  EXPECT_NEAR(beam.profile.mean, 1.0, 0.01);
  EXPECT_NEAR(beam.profile.linear, 1.5 * 6.0 / 4.0, 0.02);
  EXPECT_NEAR(beam.profile.square, 2.5 * 0.5 * 6.0 * (3.0 / 5.0 - 1.0 / 3.0), 0.02);
}

}  // namespace
}  // namespace lippmann
