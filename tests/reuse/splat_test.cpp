// The eye at (0, 0, 10) sees the square from -4 to 4 mm in the plane z = 0 as 8 x 8 pixels, so a pixel is 1 mm wide at
// z = 0, 0.5 mm at z = 5 and 2 mm at z = -10.
#include "reuse/splat.hpp"

#include <gtest/gtest.h>

#include "reuse/point_images.hpp"

namespace lippmann {
namespace {

using test::KnownMotion;
using test::set_point;
using test::shift;

constexpr int kSize = 8;

Optics view() {
  Optics optics;
  optics.panel = {kSize, kSize, 1.0f};
  optics.model = SingleView{10.0f, {0.0f, 0.0f}};
  return optics;
}

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kSize + x); }

SplatBuffer splatted(const PointImage& image, const Motion& motion, bool z_buffer = true, const Optics& optics = view()) {
  SplatBuffer buffer;
  Splatter(optics, {SplatMode::kView, z_buffer}).splat(image, motion, ThreadPool(1), buffer);
  return buffer;
}

std::vector<std::size_t> covered(const SplatBuffer& buffer) {
  std::vector<std::size_t> pixels;
  for (std::size_t p = 0; p < buffer.keys.size(); ++p)
    if (buffer.keys[p] != 0) pixels.push_back(p);
  return pixels;
}

TEST(Splat, motion_in_pixels_depends_on_depth) {
  for (const auto& [z, pixels] : {std::pair{0.0f, 1}, {5.0f, 2}}) {
    PointImage image = test::empty_points(view().panel);
    set_point(image, at(3, 4), z);
    const KnownMotion motion({shift(1.0f, 0.0f, 0.0f)});
    const SplatBuffer buffer = splatted(image, motion.motion);
    ASSERT_EQ(covered(buffer), (std::vector<std::size_t>{at(3 + pixels, 4)})) << z;
    EXPECT_EQ(SplatBuffer::source(buffer.keys[at(3 + pixels, 4)]), at(3, 4));
    EXPECT_FLOAT_EQ(SplatBuffer::depth(buffer.keys[at(3 + pixels, 4)]), z);
  }
}

TEST(Splat, motion_upwards_goes_to_a_lower_row) {
  PointImage image = test::empty_points(view().panel);
  set_point(image, at(3, 4), 0.0f);
  const KnownMotion motion({shift(0.0f, 2.0f, 0.0f)});
  EXPECT_EQ(covered(splatted(image, motion.motion)), (std::vector<std::size_t>{at(3, 2)}));
}

TEST(Splat, nearest_point_wins_in_any_order) {
  for (const bool near_comes_first : {true, false}) {
    PointImage image = test::empty_points(view().panel);
    const std::size_t near = near_comes_first ? at(2, 4) : at(6, 4), far = near_comes_first ? at(6, 4) : at(2, 4);
    // Both points move by 2 pixels to the middle: 1 mm at z = 5, and 4 mm at z = -10.
    const float sign = near_comes_first ? 1.0f : -1.0f;
    set_point(image, near, 5.0f, 0);
    set_point(image, far, -10.0f, 1);
    const KnownMotion motion({shift(sign, 0, 0), shift(-4 * sign, 0, 0)});
    const SplatBuffer buffer = splatted(image, motion.motion);
    ASSERT_EQ(covered(buffer), (std::vector<std::size_t>{at(4, 4)}));
    EXPECT_EQ(SplatBuffer::source(buffer.keys[at(4, 4)]), near);
    EXPECT_FLOAT_EQ(SplatBuffer::depth(buffer.keys[at(4, 4)]), 5.0f);
  }
}

TEST(Splat, depths_are_ordered_across_the_plane) {
  const float depths[] = {-20.0f, -1.0f, -0.25f, 0.0f, 0.25f, 1.0f, 8.0f};
  for (std::size_t i = 1; i < std::size(depths); ++i) {
    PointImage image = test::empty_points(view().panel);
    set_point(image, at(4, 4), depths[i - 1], 0);
    set_point(image, at(4, 5), depths[i], 1);
    // Moves the second point up by one pixel, which is 1 - z / 10 mm at its depth z.
    const KnownMotion motion({shift(0, 0, 0), shift(0, 1.0f - depths[i] / 10.0f, 0)});
    EXPECT_EQ(SplatBuffer::source(splatted(image, motion.motion).keys[at(4, 4)]), at(4, 5)) << depths[i];
  }
}

TEST(Splat, ties_go_to_the_lower_source_pixel) {
  PointImage image = test::empty_points(view().panel);
  set_point(image, at(2, 4), 0.0f, 0);
  set_point(image, at(6, 4), 0.0f, 1);
  const KnownMotion motion({shift(2, 0, 0), shift(-2, 0, 0)});
  EXPECT_EQ(SplatBuffer::source(splatted(image, motion.motion).keys[at(4, 4)]), at(2, 4));
}

TEST(Splat, without_z_buffer_the_last_point_wins) {
  PointImage image = test::empty_points(view().panel);
  set_point(image, at(2, 4), 5.0f, 0);
  set_point(image, at(6, 4), -10.0f, 1);
  const KnownMotion motion({shift(1, 0, 0), shift(-4, 0, 0)});
  const SplatBuffer buffer = splatted(image, motion.motion, false);
  EXPECT_EQ(SplatBuffer::source(buffer.keys[at(4, 4)]), at(6, 4));
  EXPECT_FLOAT_EQ(SplatBuffer::depth(buffer.keys[at(4, 4)]), -10.0f);
}

TEST(Splat, background_stays_behind_every_point) {
  PointImage image = test::empty_points(view().panel);
  set_point(image, at(4, 4), -kInfinity, kNoObject);
  set_point(image, at(5, 4), -kInfinity, kNoObject);
  set_point(image, at(3, 4), -100.0f);
  const KnownMotion motion({shift(11, 0, 0)});  // a pixel is 11 mm wide at this depth
  const SplatBuffer buffer = splatted(image, motion.motion);
  EXPECT_EQ(covered(buffer), (std::vector<std::size_t>{at(4, 4), at(5, 4)}));
  EXPECT_EQ(SplatBuffer::source(buffer.keys[at(4, 4)]), at(3, 4));
  EXPECT_EQ(SplatBuffer::source(buffer.keys[at(5, 4)]), at(5, 4));
}

TEST(Splat, points_outside_the_picture_are_dropped) {
  const Affine3f away[] = {shift(-4, 0, 0), shift(5, 0, 0), shift(0, 4, 0), shift(0, -5, 0), shift(0, 0, 11)};
  for (const Affine3f& motion_of_all : away) {
    PointImage image = test::empty_points(view().panel);
    set_point(image, at(3, 3), 0.0f);
    const KnownMotion motion({motion_of_all});
    EXPECT_TRUE(covered(splatted(image, motion.motion)).empty());
  }
}

TEST(Splat, points_beyond_the_rays_are_dropped) {
  Optics optics = view();
  optics.z_front_mm = 4.0f, optics.z_back_mm = 6.0f;
  PointImage image = test::empty_points(optics.panel);
  set_point(image, at(3, 4), 0.0f);
  for (const auto& [z, seen] : {std::pair{3.9f, true}, {4.1f, false}, {-5.9f, true}, {-6.1f, false}}) {
    const KnownMotion motion({shift(0, 0, z)});
    EXPECT_EQ(!covered(splatted(image, motion.motion, true, optics)).empty(), seen) << z;
  }
}

TEST(Splat, missed_pixels_have_no_points) {
  const PointImage image = test::empty_points(view().panel);
  const KnownMotion motion({shift(0, 0, 0), shift(1, 0, 0)});
  EXPECT_TRUE(covered(splatted(image, motion.motion)).empty());
}

}  // namespace
}  // namespace lippmann
