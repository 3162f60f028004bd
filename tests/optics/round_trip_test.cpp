// Follows a pixel to its ray and to a point on this ray. pixels_seeing() must map the point back to the pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "optics/ray_generator.hpp"
#include "random_optics.hpp"

namespace lippmann {
namespace {

using test::OpticsSampler;

float distance_to_nearest(const std::vector<Vec2f>& pixels, Vec2f wanted) {
  float nearest = kInfinity;
  for (const Vec2f& p : pixels) nearest = std::min(nearest, glm::distance(p, wanted));
  return nearest;
}

/// Rounding error of pixels_seeing() in pixels. Near a lens array, an error in mm is multiplied by g / (|Z| m), with
/// the depth Z, the gap g and the pixel width m; far from the array and for pinholes, by about 1 / m.
float rounding_px(const Optics& optics, const Ray& ray, float z) {
  const float m = optics.panel.pixel_pitch_mm;
  const float size = std::abs(ray.origin.x) + std::abs(ray.origin.y) + std::abs(z);
  float per_mm = 1.0f / m;
  if (const auto* s = std::get_if<LenticularSheet>(&optics.model)) per_mm += s->gap_mm / (std::abs(z) * m);
  if (const auto* a = std::get_if<MicrolensArray>(&optics.model)) per_mm += a->gap_mm / (std::abs(z) * m);
  // The error grows near the depth at which a lens of a slanted panel shows one point over its full width. The test
  // depths differ from this depth by at least half of it, so the error at most doubles.
  if (std::holds_alternative<SlantedPanel>(optics.model)) per_mm *= 2.0f;
  return 6e-8f * size * per_mm;
}

void check_round_trip(OpticsSampler& random, int model, float sign) {
  const Optics optics = random.every(model);
  ASSERT_NO_THROW(validate(optics));
  const RayGenerator generator(optics);
  const float gap = test::gap_of(optics);
  for (int sample = 0; sample < 50; ++sample) {
    const Vec2f pixel(random.uniform(1.0f, film_size(optics).x - 1.0f), random.uniform(1.0f, optics.panel.height - 1.0f));
    const Ray ray = generator.ray(pixel);
    const float z = sign * random.uniform(gap, std::min(30.0f * gap, 0.95f * resolved_z_front_mm(optics)));
    std::vector<Vec2f> seeing;
    pixels_seeing(optics, test::at_depth(ray, z), seeing);
    const auto* views = std::get_if<MultiView>(&optics.model);
    const bool padding = views != nullptr && (pixel.x >= film_size(optics).x / views->columns * views->columns ||
                                              pixel.y < optics.panel.height % views->rows);
    if (padding) continue;
    // About 16 rounding errors add up. The interface promises 1e-2 pixel.
    const float tolerance = std::min(1e-2f, 16.0f * rounding_px(optics, ray, z) + 1e-4f);
    EXPECT_LT(distance_to_nearest(seeing, pixel), tolerance)
        << test::model_name(optics) << " (kind " << model << "), pixel " << pixel.x << " " << pixel.y << ", z " << z
        << ", seen by " << seeing.size();
  }
}

class RoundTrip : public testing::TestWithParam<int> {};

TEST_P(RoundTrip, points_in_front_return_to_their_pixel) {
  OpticsSampler random(1000 + GetParam());
  for (int trial = 0; trial < 60; ++trial) check_round_trip(random, GetParam(), 1.0f);
}

TEST_P(RoundTrip, points_behind_return_to_their_pixel) {
  OpticsSampler random(2000 + GetParam());
  for (int trial = 0; trial < 60; ++trial) check_round_trip(random, GetParam(), -1.0f);
}

TEST_P(RoundTrip, rays_of_pixels_match_ray_of_pixel) {
  OpticsSampler random(3000 + GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    const Optics optics = random.every(GetParam());
    constexpr int kCount = 53;  // three vectors of 16 rays, and 5 more rays
    float px[kCount], py[kCount], out[6][kCount];
    for (int i = 0; i < kCount; ++i)
      px[i] = random.uniform(0.0f, film_size(optics).x), py[i] = random.uniform(0.0f, optics.panel.height);
    rays_of_pixels(optics, px, py, kCount, {out[0], out[1], out[2], out[3], out[4], out[5]});
    for (int i = 0; i < kCount; ++i) {
      const Ray ray = ray_of_pixel(optics, {px[i], py[i]});
      EXPECT_EQ(ray.origin, Vec3f(out[0][i], out[1][i], out[2][i]));
      EXPECT_EQ(ray.direction, Vec3f(out[3][i], out[4][i], out[5][i]));
    }
  }
}

TEST_P(RoundTrip, rays_start_on_z_front) {
  OpticsSampler random(4000 + GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    Optics optics = random.every(GetParam());
    if (random.coin()) optics.z_front_mm = random.uniform(-5.0f, 100.0f);
    for (int sample = 0; sample < 20; ++sample) {
      const Ray ray =
          ray_of_pixel(optics, {random.uniform(0.0f, film_size(optics).x), random.uniform(0.0f, optics.panel.height)});
      EXPECT_EQ(ray.origin.z, resolved_z_front_mm(optics));
      EXPECT_LT(ray.direction.z, 0.0f);
      EXPECT_NEAR(glm::length(ray.direction), 1.0f, 3e-7f);  // a few rounding errors of 6e-8
    }
  }
}

TEST_P(RoundTrip, z_front_does_not_change_the_line) {
  OpticsSampler random(5000 + GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    Optics near = random.every(GetParam()), far = near;
    near.z_front_mm = 10.0f, far.z_front_mm = 150.0f;
    for (int sample = 0; sample < 20; ++sample) {
      const Vec2f pixel(random.uniform(0.0f, film_size(near).x), random.uniform(0.0f, near.panel.height));
      const Ray a = ray_of_pixel(near, pixel), b = ray_of_pixel(far, pixel);
      EXPECT_EQ(a.direction, b.direction);
      // The tolerance covers relative rounding errors of 6e-8 in positions of up to 1000 mm, and in a direction over a
      // distance of 140 mm.
      EXPECT_LT(glm::distance(test::at_depth(b, 10.0f), a.origin), 5e-4f);
    }
  }
}

TEST_P(RoundTrip, points_beyond_the_rays_are_unseen) {
  OpticsSampler random(6000 + GetParam());
  Optics optics = random.every(GetParam());
  optics.z_front_mm = 20.0f, optics.z_back_mm = 30.0f;
  const Ray ray = ray_of_pixel(optics, {film_size(optics).x / 2 + 0.3f, optics.panel.height / 2 + 0.3f});
  std::vector<Vec2f> seeing;
  pixels_seeing(optics, test::at_depth(ray, 21.0f), seeing);
  EXPECT_TRUE(seeing.empty());
  pixels_seeing(optics, test::at_depth(ray, -31.0f), seeing);
  EXPECT_TRUE(seeing.empty());
  pixels_seeing(optics, test::at_depth(ray, -29.0f), seeing);
  EXPECT_FALSE(seeing.empty());
}

INSTANTIATE_TEST_SUITE_P(Models, RoundTrip, testing::Range(0, OpticsSampler::kKinds), test::name_of_param);

}  // namespace
}  // namespace lippmann
