// Each sub-pixel behind slanted lenses has its own direction. Pixel 3 i + c of the film is the colour c of the panel's
// pixel i.
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/refocus.hpp"
#include "recorded.hpp"

namespace lippmann {
namespace {

/// 240 x 160 pixels of 0.2 mm below 30.3 lenses, which shift by three lens widths over the panel's height.
Optics slanted_panel() {
  Optics optics;
  optics.panel = {240, 160, 0.2f};
  SlantedPanel slanted;
  slanted.periods = 30.3, slanted.tilt = -0.1, slanted.center = 0.2;
  slanted.view_cone = radians(40.0f);
  slanted.distance_mm = 150.0f;
  optics.model = slanted;
  return optics;
}

template <class Color>
RenderedPanel record_sub_pixels(const Optics& optics, double z, const Color& color) {
  const RenderedPanel film = test::record(optics, z, color);
  const Vec2i size = picture_size(optics);
  RenderedPanel panel{optics, Image(size.x, size.y, 3)};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int c = 0; c < 3; ++c) panel.picture.pixel(x, y)[c] = film.picture.pixel(3 * x + c, y)[c];
  return panel;
}

Vec3f long_waves(Vec2d p) { return test::waves(0.22 * p); }

Image view_from(const RenderedPanel& panel, Vec3d eye_mm) {
  const ThreadPool pool(1);
  EyeView view;
  view.eye_mm = eye_mm;
  return eye_view(panel, view, pool);
}

// All sub-pixels below a lens of 1.6 mm show one position, up to 0.8 mm beside the right point. For waves of amplitude
// 0.4 and 0.2 rad/mm, the largest error is 0.4 * 0.2 * 0.8 = 0.06 (24 dB), and the mean error half of it (30 dB).
TEST(SlantedSight, scenes_equal_direct_views_within_a_lens) {
  const Optics optics = slanted_panel();
  for (const double z : {-8.0, 0.0, 8.0}) {
    const RenderedPanel panel = record_sub_pixels(optics, z, long_waves);
    for (const Vec3d eye : {Vec3d(0, 0, 150), Vec3d(40, 0, 150), Vec3d(-45, 0, 150)}) {
      const Image direct = test::seen_directly(optics, picture_size(optics), eye, z, long_waves);
      EXPECT_GE(test::linear_psnr(view_from(panel, eye), direct, 8), 30.0) << z << " " << eye.x;
    }
  }
}

TEST(SlantedSight, eye_sees_its_own_direction) {
  // The colour of each sub-pixel is its position in the view cone, from 0 (left) to 1 (right).
  const Optics optics = slanted_panel();
  const Vec2i size = picture_size(optics);
  RenderedPanel panel{optics, Image(size.x, size.y, 3)};
  const double cone = radians(40.0f);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int c = 0; c < 3; ++c) {
        const Vec2d at_viewer = test::meets(optics, 3 * x + c, y, 150.0);
        panel.picture.pixel(x, y)[c] = static_cast<float>(std::atan(at_viewer.x / 150.0) / cone + 0.5);
      }
  const EyeSampler sampler(panel, SampleFilter::kNearest);
  for (const double share : {0.2, 0.5, 0.77}) {
    const Viewer eye = viewer_in_zone(optics, share);
    for (int i = -10; i <= 10; ++i) {
      const Vec3f seen = sampler.color(eye, {1.37 * i, 0.9 * i});
      // The nearest sub-pixel of a colour is up to half a pixel away. With 30.3 lenses over 240 pixels, this is 0.5 *
      // 30.3 / 240 = 0.063 of the view cone.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], share, 0.064) << share << " " << i << " " << c;
    }
  }
  EXPECT_EQ(share_out_of_zone(optics, viewer_in_zone(optics, 0.9)), 0.0);
  EXPECT_EQ(share_out_of_zone(optics, viewer_in_zone(optics, 1.1)), 1.0);
}

// The rays from the two ends of the viewing zone separate by 2 tan(20 degrees) mm per mm of depth. The picture is
// blurred where this separation is about half the length of a wave, which spans 19 lenses.
TEST(SlantedSight, refocused_colours_are_sharp_at_their_depth) {
  const Optics optics = slanted_panel();
  const ThreadPool pool(1);
  for (const double z : {-20.0, 20.0}) {
    const RenderedPanel panel = record_sub_pixels(optics, z, long_waves);
    const Vec2i size = picture_size(optics);
    const Image truth = test::seen_directly(optics, size, {0, 0, 150}, z, long_waves);
    for (int c = 0; c < 3; ++c) {
      const auto only = [c](Image image) {
        for (std::size_t i = 0; i < image.data.size(); ++i)
          if (static_cast<int>(i % 3) != c) image.data[i] = 0.0f;
        return image;
      };
      const double sharp = test::linear_psnr(only(refocus(panel, z, size, pool)), only(truth), 16);
      EXPECT_GE(sharp, 35.0) << z << " " << c;
      if (c == 1) continue;  // the green stripes are horizontal, so horizontal parallax does not blur them
      EXPECT_LE(test::linear_psnr(only(refocus(panel, -z, size, pool)), only(truth), 16), sharp - 10.0) << z << " " << c;
    }
  }
}

}  // namespace
}  // namespace lippmann
