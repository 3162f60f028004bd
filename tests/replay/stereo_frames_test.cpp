#include "replay/stereo_frames.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "lippmann/optics/viewing.hpp"
#include "recorded.hpp"

namespace lippmann {
namespace {

using test::record;

/// A bar at x = 0. Its soft edges prevent sampling from shifting its centre.
Vec3f bar(Vec2d at) { return Vec3f(static_cast<float>(std::exp(-at.x * at.x / 8.0))); }

double centre_mm(const LightField& field, int view, double width_mm) {
  const Image image = std::get<Image>(view_of(field, view));
  double sum = 0.0, weight = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      sum += (x + 0.5) * image.pixel(x, y)[0];
      weight += image.pixel(x, y)[0];
    }
  return (sum / weight / image.width - 0.5) * width_mm;
}

double disparity_of_plane(const Optics& optics, double z, double ipd) {
  const ThreadPool pool(1);
  const RenderedPanel panel = record(optics, z, bar);
  const LightField pair = stereo_views(panel, default_eye_mm(optics), ipd, pool);
  const double width = display_window(optics).size.x;
  return centre_mm(pair, 1, width) - centre_mm(pair, 0, width);
}

// From the viewing distance D, a bar at depth z has the disparity -ipd z / (D - z), with eyes `ipd` apart. Interpolated
// views have errors of a tenth of a pixel.
TEST(StereoFrames, eyes_see_the_disparity_of_similar_triangles) {
  const Optics optics = test::quilt();
  const double distance = viewing_distance_mm(optics), pixel = optics.panel.pixel_pitch_mm, ipd = 20.0;
  for (const double z : {0.0, -5.0, 5.0})
    EXPECT_NEAR(disparity_of_plane(optics, z, ipd), -ipd * z / (distance - z), 0.1 * pixel) << z;
}

TEST(StereoFrames, views_have_the_shape_of_the_display) {
  const ThreadPool pool(1);
  const Optics optics = test::quilt();
  const LightField pair = stereo_views(record(optics, 0.0, bar), default_eye_mm(optics), 10.0, pool);
  const Vec2d window = display_window(optics).size;
  EXPECT_EQ(pair.grid, (ViewGrid{2, 1}));
  EXPECT_DOUBLE_EQ(pair.aspect, window.x / window.y);
  EXPECT_EQ(pair.view_size, natural_view_size(optics));
}

}  // namespace
}  // namespace lippmann
