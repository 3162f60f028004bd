#include "reuse/epipolar.hpp"

#include <gtest/gtest.h>

#include "optics/random_optics.hpp"
#include "reuse/point_images.hpp"
#include "reuse/splat.hpp"

namespace lippmann {
namespace {

using test::at_depth;

Optics sheet(float viewing_distance) {
  Optics optics;
  optics.panel = {96, 4, 0.0f};
  LenticularSheet s;
  s.gap_mm = 2.0f;
  s.viewing_distance_mm = viewing_distance;
  optics.panel.pixel_pitch_mm = (1.0f + s.gap_mm / viewing_distance) / 6.0f;
  optics.model = s;
  return optics;
}

/// Brightness is linear in x, so that interpolation is exact. Steps of 0.2 per lens give enough contrast to match
/// neighbouring views.
float ramp(float x) { return 2.0f + 0.2f * x; }

using test::centre_of;

PointImage ramp_at_depth(const Optics& optics, float z) {
  PointImage image = test::empty_points(optics.panel);
  for (std::uint32_t p = 0; p < image.points.z.size(); ++p) {
    test::set_point(image, p, z);
    for (std::size_t c = 0; c < 3; ++c)
      image.film.data[3 * p + c] = ramp(at_depth(ray_of_pixel(optics, centre_of(optics, p)), z).x) * 0.1f;
  }
  return image;
}

TEST(EpipolarSampler, linear_colours_are_interpolated_exactly) {
  for (const float viewing_distance : {kInfinity, 300.0f})
    for (const float z : {-3.0f, -0.8f, 0.0f, 0.5f, 2.7f}) {
      const Optics optics = sheet(viewing_distance);
      const PointImage image = ramp_at_depth(optics, z);
      const test::KnownMotion motion({test::shift(0.3f, 0, 0)});
      const Splatter splatter(optics, {});
      const EpipolarSampler sampler(optics, Encoding::kSrgb);
      for (std::uint32_t p = 96 + 24; p < 96 + 72; ++p) {
        const auto target = splatter.landing(p, z, 0, motion.motion);
        ASSERT_TRUE(target);
        float color[3];
        sampler.colors(image, motion.motion, {&p, 1}, color);
        const float x = at_depth(ray_of_pixel(optics, centre_of(optics, *target)), z).x;
        // The tolerance covers rounding of coordinates of up to 50 pixels, with colours that change by 0.02 per mm.
        EXPECT_NEAR(color[0], 0.1f * ramp(x - 0.3f), 1e-5f) << "z " << z << ", pixel " << p;
      }
    }
}

TEST(EpipolarSampler, contrast_is_measured_within_the_view) {
  const Optics optics = sheet(kInfinity);
  PointImage image = test::empty_points(optics.panel);
  for (float& value : image.film.data) value = 0.25f;
  const std::uint32_t pixel = 96 + 40;
  image.film.data[3 * pixel + 1] = 0.75f;
  EpipolarSampler(optics, Encoding::kSrgb).find_contrast(image, ThreadPool(1));
  for (std::uint32_t p = 0; p < image.contrast.size(); ++p) {
    const int expected = p == pixel       ? kLeftDiffers | kRightDiffers
                         : p == pixel - 6 ? kRightDiffers
                         : p == pixel + 6 ? kLeftDiffers
                                          : 0;
    EXPECT_EQ(image.contrast[p], expected) << p;
  }
}

TEST(EpipolarSampler, background_does_not_mix_with_the_foreground) {
  // A white object (0) covers the left half in front of a black one (1). Only the black object moves, by 0.4 mm, so its
  // samples lie between pixels. Away from the edge, no black pixel may become grey.
  const Optics optics = sheet(kInfinity);
  PointImage image = test::empty_points(optics.panel);
  for (std::uint32_t p = 0; p < image.points.z.size(); ++p) {
    const bool left = p % 96 < 48;
    test::set_point(image, p, left ? 1.0f : -1.0f, left ? 0 : 1);
    for (std::size_t c = 0; c < 3; ++c) image.film.data[3 * p + c] = left ? 1.0f : 0.0f;
  }
  const test::KnownMotion motion({Affine3f{}, test::shift(0.4f, 0, 0)});
  const EpipolarSampler sampler(optics, Encoding::kSrgb);
  for (std::uint32_t p = 96 + 48 + 6; p < 96 + 90; ++p) {
    float color[3];
    sampler.colors(image, motion.motion, {&p, 1}, color);
    EXPECT_EQ(color[0], 0.0f) << p;
  }
}

TEST(EpipolarSampler, needs_whole_pixels_below_lenses) {
  EXPECT_TRUE(EpipolarSampler::suits(sheet(300.0f)));
  Optics other = sheet(kInfinity);
  other.panel.pixel_pitch_mm *= 0.93f;
  EXPECT_FALSE(EpipolarSampler::suits(other));
  other.model = SingleView{};
  EXPECT_FALSE(EpipolarSampler::suits(other));
  other.model = MultiView{};
  EXPECT_FALSE(EpipolarSampler::suits(other));
}

}  // namespace
}  // namespace lippmann
