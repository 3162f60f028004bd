#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/refocus.hpp"
#include "recorded.hpp"
#include "replay/depth_order.hpp"
#include "replay/rotate_elemental.hpp"
#include "replay/spoc.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::record, test::waves;
using testing::HasSubstr;

RenderedPanel with(const Optics& optics, const PixelMap& map, const RenderedPanel& panel) {
  return {optics, apply(map, panel.picture)};
}

RenderedPanel rotated(const RenderedPanel& panel) {
  return with(panel.optics, rotated_elemental_images(panel.optics, "test"), panel);
}

/// The conversions copy nearest pixels and could miss a point, so the spot is several lenses wide.
RenderedPanel record_spot(const Optics& optics, Vec3d point_mm) {
  return record(optics, point_mm.z, [&](Vec2d p) {
    const Vec2d from = p - Vec2d(point_mm);
    return Vec3f(std::exp(-glm::dot(from, from) / (2.0 * 0.8 * 0.8)));
  });
}

struct Peak {
  double depth = 0.0;
  Vec2d place{0.0};
};

Peak peak_of(const RenderedPanel& panel, double step, int count) {
  const ThreadPool pool(1);
  const Vec2i size = lens_grid(panel.optics);
  Peak peak;
  float highest = 0.0f;
  for (int i = -count; i <= count; ++i) {
    const Image picture = refocus(panel, i * step, size, pool);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (picture.pixel(x, y)[0] > highest) {
          highest = picture.pixel(x, y)[0];
          peak = {i * step, display_window(panel.optics).point_at({x + 0.5, y + 0.5}, size)};
        }
  }
  return peak;
}

constexpr double kDepthStep = 2.0;  ///< the gap in mm, which is also the depth step of refocusing

TEST(RotateElemental, point_then_peaks_at_the_opposite_depth) {
  Optics lenslets = test::lenslets();
  lenslets.panel.height = 70;
  for (const Optics& optics : {test::sheet(), lenslets})
    for (int i = -9; i <= 9; ++i) {
      if (std::abs(i) < 2) continue;
      const auto z = static_cast<float>(i * kDepthStep);
      EXPECT_NEAR(peak_of(rotated(test::record_point(optics, {0.37f, 0.61f, z})), kDepthStep, 11).depth, -z, kDepthStep) << z;
    }
}

TEST(RotateElemental, twice_is_the_identity) {
  for (const Optics& optics : {test::sheet(), test::lenslets(150.0f), test::quilt()}) {
    const RenderedPanel panel = record(optics, 5.0, waves);
    EXPECT_NE(rotated(panel).picture.data, panel.picture.data);
    EXPECT_EQ(rotated(rotated(panel)).picture.data, panel.picture.data);
  }
}

TEST(RotateElemental, pixels_are_rotated_about_their_lens_centre) {
  const PixelMap map = rotated_elemental_images(test::lenslets(), "test");
  EXPECT_EQ(map.source[0], 6u * 210u + 6u);
  EXPECT_EQ(map.source[3 * 210 + 3], 3u * 210u + 3u);
  EXPECT_EQ(map.source[8 * 210 + 16], 12u * 210u + 18u);
}

TEST(RotateElemental, fractional_lenses_are_refused) {
  EXPECT_THAT(test::error_message([] { rotated_elemental_images(test::sheet(kInfinity, 0.3f), "a.png"); }),
              HasSubstr("whole number of pixels"));
}

TEST(Spoc, equal_arrays_at_0_rotate_elemental_images) {
  for (const Optics& optics : {test::sheet(), test::lenslets()}) {
    const PixelMap smart = spoc(optics, optics, {0.0, 37.0}), turned = rotated_elemental_images(optics, "test");
    EXPECT_EQ(smart.source, turned.source);
  }
}

TEST(Spoc, depth_z_becomes_distance_minus_z) {
  const Optics recorded = test::sheet();
  for (const double distance : {10.0, 20.0})
    for (const double z : {8.0, 14.0, 20.0, 26.0}) {
      // Only one lens would show points near the display, which is at `distance` from the recording array.
      if (std::abs(distance - z) < 2 * kDepthStep) continue;
      const PixelMap map = spoc(recorded, recorded, {distance, z});
      const Peak peak = peak_of(with(recorded, map, record_spot(recorded, {1.37, 0.61, z})), kDepthStep, 11);
      EXPECT_NEAR(peak.depth, distance - z, kDepthStep) << distance << " " << z;
      EXPECT_NEAR(peak.place.x, 1.37, 1.0) << distance << " " << z;
    }
}

TEST(Spoc, other_lenses_keep_the_point_in_place) {
  const Optics recorded = test::lenslets();
  const Optics display = spoc_display(recorded, {1.5, 3.3, 11});
  EXPECT_EQ(Vec2i(display.panel.width, display.panel.height), Vec2i(220, 220));  // 30 mm wide: 20 lenses of 11 pixels
  EXPECT_EQ(whole_pixels_per_lens(display), Vec2i(11));
  const PixelMap map = spoc(recorded, display, {24.0, 14.0});
  const Peak peak = peak_of(with(display, map, record_spot(recorded, {1.4, -2.2, 14.0})), kDepthStep, 8);
  EXPECT_NEAR(peak.depth, 24.0 - 14.0, kDepthStep);
  EXPECT_NEAR(peak.place.x, 1.4, 1.0);
  EXPECT_NEAR(peak.place.y, -2.2, 1.0);
}

TEST(Spoc, index_worked_out_by_hand) {
  // 40 lenses of 1 mm have 9 pixels each and a gap of 2 mm. The middle pixel of lens 20, 184 at x = 0.5 mm, has a
  // perpendicular ray, so its source is the same pixel. Pixel 187 is 3/9 mm to the right, so its ray has the slope
  // -1/6. This ray meets the recording array (z = 12 mm) at 0.5 - 12/6 = -1.5 mm, the centre of lens 18, and the reference
  // plane (z = 6 mm) at 0.5 - 6/6 = -0.5 mm. Lens 18 records this point at -(-0.5 + 1.5) * 2 / 6 = -1/3 mm from its
  // centre, or -3 pixels. The source is pixel 18 * 9 + 4 - 3 = 163.
  const PixelMap map = spoc(test::sheet(), test::sheet(), {12.0, 6.0});
  EXPECT_EQ(map.source[50 * 360 + 184], 50u * 360u + 184u);
  EXPECT_EQ(map.source[50 * 360 + 187], 50u * 360u + 163u);
}

TEST(Spoc, impossible_planes_are_refused) {
  const auto message = [](double distance, double reference) {
    return test::error_message([&] { spoc(test::sheet(), test::sheet(), {distance, reference}); });
  };
  EXPECT_THAT(message(std::nan(""), 10.0), HasSubstr("spoc"));
  EXPECT_THAT(message(10.0, 0.0), HasSubstr("reference-plane"));
  EXPECT_THAT(message(10.0, -4.0), HasSubstr("reference-plane"));
  EXPECT_THAT(test::error_message([] { spoc(test::quilt(), test::quilt(), {}); }), HasSubstr("lens array"));
}

RenderedPanel bar_before_wall(const Optics& optics, double bar_z, double wall_z) {
  RenderedPanel panel = record(optics, wall_z, waves);
  for (int y = 0; y < panel.picture.height; ++y)
    for (int x = 0; x < panel.picture.width; ++x)
      if (std::abs(test::meets(optics, x, y, bar_z).x) < 3.0) std::fill_n(panel.picture.pixel(x, y), 3, 0.05f);
  return panel;
}

TEST(Spoc, two_tiers_show_correct_depth) {
  const Optics optics = test::sheet();
  const double distance = 12.0;
  const RenderedPanel recorded = bar_before_wall(optics, 8.0, 16.0);
  const RenderedPanel truth = bar_before_wall(optics, distance - 8.0, distance - 16.0);
  const RenderedPanel converted = with(optics, spoc(optics, optics, {distance, 12.0}), recorded);
  const Vec2i size = lens_grid(optics);
  const ThreadPool pool(1);
  for (const double across : {0.2, 0.3, 0.7, 0.8}) {
    EyeView view;
    view.eye_mm = {zone_x_mm(optics, across, 2000.0), 0.0, 2000.0}, view.size = size;
    const Image seen = eye_view(converted, view, pool), should = eye_view(truth, view, pool);
    const Image one_tier = eye_view(recorded, view, pool);
    // At z = 16 mm, lenses and pixels sample the wall in steps of 0.9 mm, so positions have errors of up to 0.45 mm. A wave of
    // amplitude 0.4 and 0.95 rad/mm changes by up to 0.4 * 0.95 * 0.45 = 0.17, which is 15 dB; the mean error is
    // smaller.
    EXPECT_GE(test::linear_psnr(seen, should, 5), 17.0) << across;
    EXPECT_LT(test::linear_psnr(one_tier, should, 5), 14.0) << across;
  }
}

TEST(DepthOrder, rotation_inverts_a_recorded_plane) {
  const Optics optics = test::lenslets(150.0f);
  const ThreadPool pool(1);
  for (const double z : {-9.0, 9.0}) {
    const RenderedPanel panel = record(optics, z, waves), turned = rotated(panel);
    Image depth(30, 30, 1);
    std::fill(depth.data.begin(), depth.data.end(), static_cast<float>(z));
    const auto order = [&](const RenderedPanel& shown) {
      EyeView left;
      left.eye_mm = {-10, 0, 150}, left.size = {30, 30};
      EyeView right = left;
      right.eye_mm.x = 15;
      return measure_depth_order(eye_view(shown, left, pool), eye_view(shown, right, pool), depth, 150.0, 25.0, 1.0);
    };
    const DepthOrder as_recorded = order(panel), as_turned = order(turned);
    EXPECT_GT(z < 0 ? as_recorded.behind_db : as_recorded.front_db, 3.0);
    EXPECT_LT(z < 0 ? as_turned.behind_db : as_turned.front_db, -3.0);
    EXPECT_GT(z < 0 ? as_recorded.behind_pixels : as_recorded.front_pixels, 500);
  }
}

}  // namespace
}  // namespace lippmann
