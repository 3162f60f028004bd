#include "lippmann/replay/eye_view.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "recorded.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::linear_psnr, test::record, test::seen_directly, test::waves;
using testing::HasSubstr;

Image view_from(const RenderedPanel& panel, Vec3d eye_mm, Vec2i size, SampleFilter filter = SampleFilter::kLinear) {
  const ThreadPool pool(1);
  EyeView view;
  view.eye_mm = eye_mm, view.size = size, view.filter = filter;
  return eye_view(panel, view, pool);
}

/// PSNR in dB of the eye's view of the plane `z` against the plane seen without lenses. Three pixels at the edges are
/// left out, where an eye at the side sees past the panel.
double psnr_of_plane(const Optics& optics, Vec3d eye_mm, double z) {
  const RenderedPanel panel = record(optics, z, waves);
  const Vec2i size = lens_grid(optics);
  return linear_psnr(view_from(panel, eye_mm, size), seen_directly(optics, size, eye_mm, z, waves), 3);
}

// In the plane z = 0, all pixels below a lens show the same point. Linear interpolation between 9 rows per mm of a
// sheet changes a wave of 0.7 rad/mm by at most (0.7 / 9)^2 / 8 = 8e-4, which is 62 dB.
TEST(EyeView, plane_of_lenses_equals_direct_view) {
  // A sheet shows rows at their right height only to eyes at the height and distance of its design.
  for (const Vec3d eye : {Vec3d(0, 0, 100), Vec3d(15, 0, 100), Vec3d(-17, 0, 100)})
    EXPECT_GE(psnr_of_plane(test::sheet(100.0f), eye, 0.0), 60.0) << eye.x;
  for (const Vec3d eye : {Vec3d(0, 0, 100), Vec3d(15, 4, 100), Vec3d(-17, -8, 100), Vec3d(3, 2, 140)}) {
    EXPECT_GE(psnr_of_plane(test::lenslets(100.0f), eye, 0.0), 60.0) << eye.x;
    EXPECT_GE(psnr_of_plane(test::quilt(), eye, 0.0), 60.0) << eye.x;
  }
  for (const Vec3d eye : {Vec3d(0, 0, 1e5), Vec3d(2e4, 10, 1e5)}) {
    EXPECT_GE(psnr_of_plane(test::sheet(), eye, 0.0), 60.0) << eye.x;
    EXPECT_GE(psnr_of_plane(test::lenslets(), eye, 0.0), 60.0) << eye.x;
  }
}

TEST(EyeView, slanted_and_hexagonal_lenses_equal_direct_view) {
  const Vec3d eye(9, 0, 100);
  for (const Optics& optics : {test::sheet(100.0f, 0.3f), test::lenslets(100.0f, LensPacking::kHexagonal)}) {
    const RenderedPanel panel = record(optics, 0.0, waves);
    const ThreadPool pool(1);
    const EyeSampler sampler(panel, SampleFilter::kLinear);
    for (int k = -8; k <= 8; ++k) {
      // Compares points on the axes of lenses. For the slanted sheet, `at` is the point of lens k's axis at y = 1.3 mm.
      // For the hexagonal array, `at` is the centre of lens k in a row.
      const auto* s = std::get_if<LenticularSheet>(&optics.model);
      const float pitch = s ? s->lens_pitch_mm : std::get<MicrolensArray>(optics.model).lens_pitch_mm;
      const Vec2d at =
          s ? Vec2d(((k + 0.5) * pitch - 1.3 * std::sin(0.3)) / std::cos(0.3), 1.3) : Vec2d((k + 0.5) * pitch, 0.5 * pitch);
      const Vec3f seen = sampler.color(viewer_at(eye), at), direct = waves(at);
      // The tolerance covers linear interpolation of a wave of 0.95 rad/mm between 9 pixels per mm: (0.95 / 9)^2 / 8 =
      // 1.4e-3.
      EXPECT_NEAR(seen.x, direct.x, 2e-3f) << k;
      EXPECT_NEAR(seen.y, direct.y, 2e-3f) << k;
    }
  }
}

// At depth z, a pixel of width m is magnified to w = |z| m / g, with the gap g. The relative error of a wave of 1
// rad/mm is about w^2 / 8.
TEST(EyeView, error_grows_with_depth_within_magnified_pixel) {
  const Vec3d eye(6, 0, 100);
  for (const Optics& optics : {test::sheet(100.0f), test::lenslets(100.0f)}) {
    const double near = psnr_of_plane(optics, eye, -2.0), mid = psnr_of_plane(optics, eye, -6.0),
                 far = psnr_of_plane(optics, eye, -14.0);
    EXPECT_GT(near, mid);
    EXPECT_GT(mid, far);
    // At z = -2 mm, with 7 pixels per mm and a gap of 2 mm, the blur has the width w = 2 * (1/7) / 2 = 0.14 mm. Its error of
    // about w^2 / 8 = 2.5e-3 is a PSNR of 52 dB.
    EXPECT_GT(near, 45.0);
    EXPECT_GT(psnr_of_plane(optics, eye, 6.0), 30.0);
  }
}

/// All pixels below lens k get the value k + 0.5.
RenderedPanel numbered_lenses(const Optics& optics) {
  return record(optics, 0.0, [](Vec2d p) { return Vec3f(std::floor(p.x) + 0.5); });
}

TEST(EyeView, neighbour_pixels_are_seen_beyond_the_zone) {
  // With a gap of 2 mm, an eye at infinity with slope 0.2 sees the panel at l - 2 * 0.2 = l - 0.4 through the lens at
  // l. This place is below the same lens, which is 1 mm wide. With slope 0.3, the eye sees l - 0.6, below the left
  // neighbour.
  const RenderedPanel panel = numbered_lenses(test::sheet());
  const EyeSampler sampler(panel, SampleFilter::kLinear);
  const Vec2d at(3.5, 0.0);
  EXPECT_EQ(sampler.color({{0.2, 0.0}, 0.0}, at).x, 3.5f);
  EXPECT_EQ(sampler.color({{0.3, 0.0}, 0.0}, at).x, 2.5f);
  EXPECT_EQ(sampler.color({{-0.3, 0.0}, 0.0}, at).x, 4.5f);
  EXPECT_EQ(share_out_of_zone(panel.optics, {{0.2, 0.0}, 0.0}), 0.0);
  EXPECT_EQ(share_out_of_zone(panel.optics, {{0.3, 0.0}, 0.0}), 1.0);
}

TEST(EyeView, zone_has_no_flipped_lens) {
  for (const Optics& optics : {test::sheet(100.0f), test::lenslets(100.0f), test::quilt(), test::sheet(100.0f, 0.3f)}) {
    for (const double share : {0.01, 0.3, 0.5, 0.99})
      EXPECT_EQ(share_out_of_zone(optics, viewer_in_zone(optics, share)), 0.0) << share;
    EXPECT_EQ(share_out_of_zone(optics, viewer_in_zone(optics, 1.02)), 1.0);
    EXPECT_EQ(share_out_of_zone(optics, viewer_in_zone(optics, -0.02)), 1.0);
  }
}

TEST(EyeView, eyes_see_their_pixel_columns_from_right) {
  Optics optics = test::sheet(100.0f);
  RenderedPanel panel{optics, Image(360, 120, 3)};
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 360; ++x) panel.picture.pixel(x, y)[0] = static_cast<float>(x % 9);
  for (const SampleFilter filter : {SampleFilter::kNearest, SampleFilter::kLinear}) {
    const EyeSampler sampler(panel, filter);
    for (int i = 0; i < 9; ++i)
      EXPECT_NEAR(sampler.color(viewer_in_zone(optics, (i + 0.5) / 9), {2.3, 1.0}).x, 8 - i, 1e-4) << i;
  }
}

TEST(EyeView, linear_filter_never_mixes_two_lenses) {
  const RenderedPanel panel = numbered_lenses(test::sheet());
  const EyeSampler sampler(panel, SampleFilter::kLinear);
  EXPECT_EQ(sampler.color({{0.2499, 0.0}, 0.0}, {3.5, 0.0}).x, 3.5f);
  EXPECT_EQ(sampler.color({{-0.2499, 0.0}, 0.0}, {3.5, 0.0}).x, 3.5f);
}

TEST(EyeView, quilt_interpolates_between_two_views) {
  const Optics optics = test::quilt();
  RenderedPanel panel{optics, Image(180, 120, 3)};
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 180; ++x) panel.picture.pixel(x, y)[0] = static_cast<float>((2 - y / 40) * 3 + x / 60);
  const Viewer eye = viewer_in_zone(optics, (4.3 + 0.5) / 9);
  EXPECT_NEAR(EyeSampler(panel, SampleFilter::kNearest).color(eye, {0, 0}).x, 4.0f, 1e-5);
  EXPECT_NEAR(EyeSampler(panel, SampleFilter::kLinear).color(eye, {0, 0}).x, 4.3f, 1e-3);
  const Viewer beyond = viewer_in_zone(optics, 1.0 + 0.5 / 9);  // beyond the zone, view 0 is visible again
  EXPECT_NEAR(EyeSampler(panel, SampleFilter::kNearest).color(beyond, {0, 0}).x, 0.0f, 1e-5);
}

TEST(EyeView, camera_grid_interpolates_across_and_up) {
  // 3 x 3 eyes, 8 mm apart, at 100 mm. The tile of each view has the value column + 10 * row.
  Optics optics = test::quilt();
  std::get<MultiView>(optics.model).baseline_mm = 8.0f;
  RenderedPanel panel{optics, Image(180, 120, 3)};
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 180; ++x) panel.picture.pixel(x, y)[0] = static_cast<float>(x / 60 + 10 * (2 - y / 40));
  const EyeSampler linear(panel, SampleFilter::kLinear), nearest(panel, SampleFilter::kNearest);
  EXPECT_NEAR(linear.color(viewer_at({8, -8, 100}), {0, 0}).x, 2.0f, 1e-4);
  EXPECT_NEAR(linear.color(viewer_at({4, 2, 100}), {3, 1}).x, 1.5f + 10 * 1.25f, 1e-4);
  EXPECT_NEAR(nearest.color(viewer_at({5, 5, 100}), {0, 0}).x, 2.0f + 20.0f, 1e-4);
  EXPECT_NEAR(linear.color(viewer_at({500, 0, 100}), {0, 0}).x, 2.0f + 10.0f, 1e-4);
  EXPECT_EQ(share_out_of_zone(optics, viewer_at({11, -11, 100})), 0.0);
  EXPECT_EQ(share_out_of_zone(optics, viewer_at({13, 0, 100})), 1.0);
  EXPECT_EQ(view_counts(optics), Vec2i(3, 3));
  EXPECT_NEAR(viewer_in_zone_vertically(optics, 2.5 / 3).slope_at_centre.y, 0.08, 1e-9);
}

TEST(EyeView, single_view_is_the_same_from_everywhere) {
  Optics optics;
  optics.panel = {30, 20, 0.5f};
  optics.model = SingleView{80.0f, {0.25f, -0.5f}};
  const RenderedPanel panel = record(optics, 0.0, waves);
  for (const Vec3d eye : {Vec3d(0, 0, 80), Vec3d(30, 20, 50)})
    EXPECT_GE(linear_psnr(view_from(panel, eye, {30, 20}), panel.picture), 120.0);
}

TEST(EyeView, crosstalk_is_a_gaussian_below_the_lens) {
  // Only one column below the lens is bright. Nine eyes, one per column, see this column with weights that sum to 1.
  // The second moment of the weights is sigma^2 of the Gaussian plus 1/12 for the width of a pixel.
  const Optics optics = test::sheet(100.0f);
  RenderedPanel panel{optics, Image(360, 120, 3)};
  for (int y = 0; y < 120; ++y) panel.picture.pixel(9 * 20 + 4, y)[0] = 1.0f;
  const double sigma = 0.8;
  const EyeSampler sampler(panel, SampleFilter::kLinear, sigma);
  double sum = 0.0, moment = 0.0;
  for (int i = 0; i < 9; ++i) {
    const double seen = sampler.color(viewer_in_zone(optics, (i + 0.5) / 9), {0.5, 0.0}).x;
    sum += seen, moment += seen * (i - 4) * (i - 4);
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(moment, sigma * sigma + 1.0 / 12, 5e-3);
}

TEST(EyeView, pupil_averages_the_eyes_within_it) {
  // Through a pupil of 30 mm at 100 mm, a plane 2.5 mm behind the display is blurred by 30 * 2.5 / 100 = 0.75 mm.
  const RenderedPanel panel = record(test::sheet(100.0f), -2.5, waves);
  const ThreadPool pool(1);
  EyeView view;
  view.eye_mm = {0, 0, 100}, view.size = {40, 120}, view.filter = SampleFilter::kLinear;
  const Image sharp = eye_view(panel, view, pool);
  view.pupil_mm = 1e-3;
  EXPECT_GE(linear_psnr(eye_view(panel, view, pool), sharp), 60.0);
  view.pupil_mm = 30.0;
  const Image blurred = eye_view(panel, view, pool);
  double sharp_contrast = 0.0, blurred_contrast = 0.0;
  for (int x = 10; x < 30; ++x) {
    sharp_contrast += std::abs(sharp.pixel(x, 60)[0] - 0.5f);
    blurred_contrast += std::abs(blurred.pixel(x, 60)[0] - 0.5f);
  }
  // Contrast of a wave of k = 0.95 rad/mm, averaged over a disc of radius r = 0.375 mm: 2 J1(k r) / (k r) = 1 - (k r)^2
  // / 8 = 0.984.
  EXPECT_NEAR(blurred_contrast / sharp_contrast, 0.984, 0.01);
}

TEST(EyeView, pupil_focuses_at_the_given_depth) {
  // A plane is 12 mm behind the display, the pupil 40 mm wide. Focused on the display, the plane is blurred by 40 * 12
  // / 100 = 4.8 mm; focused on the plane, by at most a lens of 1 mm.
  const RenderedPanel panel = record(test::lenslets(100.0f), -12.0, waves);
  const ThreadPool pool(1);
  EyeView view;
  view.eye_mm = {0, 0, 100};
  const Image sharp = eye_view(panel, view, pool);
  view.pupil_mm = 40.0;
  const double on_display = linear_psnr(eye_view(panel, view, pool), sharp, 5);
  view.focus_mm = -12.0;
  const double on_plane = linear_psnr(eye_view(panel, view, pool), sharp, 5);
  view.focus_mm = 8.0;
  EXPECT_GT(on_plane, on_display + 6.0);
  EXPECT_GT(on_display, linear_psnr(eye_view(panel, view, pool), sharp, 5));
  view.focus_mm = 100.0;
  EXPECT_THAT(test::error_message([&] { validate(view); }), HasSubstr("focus"));
}

TEST(EyeView, threads_do_not_change_a_bit) {
  const RenderedPanel panel = record(test::lenslets(100.0f), 3.0, waves);
  EyeView view;
  view.eye_mm = {2, 1, 90}, view.pupil_mm = 4, view.pupil_points = 7, view.crosstalk_px = 0.5;
  const ThreadPool one(1), three(3);
  EXPECT_EQ(eye_view(panel, view, one).data, eye_view(panel, view, three).data);
}

TEST(EyeView, cancelling_stops_before_the_next_pixel) {
  const RenderedPanel panel = record(test::lenslets(100.0f), 3.0, waves);
  const ThreadPool pool(2);
  const Image whole = eye_view(panel, {}, pool);
  const Image black(whole.width, whole.height, 3);
  EXPECT_NE(whole.data, black.data);
  Context context;
  context.cancelled = true;
  EXPECT_EQ(eye_view(panel, {}, pool, context).data, black.data);
}

TEST(EyeView, coarse_pictures_average_all_lenses) {
  const RenderedPanel panel = numbered_lenses(test::sheet());
  EXPECT_NEAR(view_from(panel, {0, 0, 4000}, {2, 1}).pixel(1, 0)[0], 10.0, 0.01);  // the mean of 0.5, 1.5, ..., 19.5
}

TEST(EyeView, eyes_that_see_nothing_are_refused) {
  const auto message = [](Vec3d eye) {
    EyeView view;
    view.eye_mm = eye;
    return test::error_message([&] { validate(view); });
  };
  EXPECT_THAT(message({0, 0, 0}), HasSubstr("not in front of the display"));
  EXPECT_THAT(message({0, 0, -5}), HasSubstr("not in front of the display"));
  EXPECT_THAT(message({0, std::nan(""), 100}), HasSubstr("not a position"));
  EXPECT_THAT(message({0, 0, INFINITY}), HasSubstr("not a position"));
  EXPECT_EQ(message({0, 0, 100}), "(no Error)");
}

}  // namespace
}  // namespace lippmann
