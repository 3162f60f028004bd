#include "lippmann/replay/epipolar_image.hpp"

#include <gmock/gmock.h>

#include "core/random.hpp"
#include "recorded.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

RenderedPanel noise(const Optics& optics) {
  RenderedPanel panel{optics, Image(optics.panel.width, optics.panel.height, 3)};
  for (std::size_t i = 0; i < panel.picture.data.size(); ++i)
    panel.picture.data[i] = unit_float(hash(5, static_cast<std::uint32_t>(i)));
  return panel;
}

TEST(EpipolarImage, row_of_whole_pixels_is_exact) {
  const RenderedPanel panel = noise(test::lenslets(100.0f));
  const Image epi = epipolar_row(panel, 4, SampleFilter::kNearest);
  ASSERT_EQ(Vec2i(epi.width, epi.height), Vec2i(30, 7));
  for (int eye = 0; eye < 7; ++eye)
    // All eyes see pixel row 3 of the pixels below lens row 4. The leftmost eye sees the rightmost pixel of each lens.
    for (int lens = 0; lens < 30; ++lens)
      ASSERT_EQ(epi.pixel(lens, eye)[1], panel.picture.pixel(7 * lens + 6 - eye, 7 * 4 + 3)[1]) << lens << " " << eye;
}

TEST(EpipolarImage, column_of_whole_pixels_is_exact) {
  const RenderedPanel panel = noise(test::lenslets(100.0f));
  const Image epi = epipolar_column(panel, 11, SampleFilter::kNearest);
  ASSERT_EQ(Vec2i(epi.width, epi.height), Vec2i(7, 30));
  for (int eye = 0; eye < 7; ++eye)
    for (int lens = 0; lens < 30; ++lens)  // the lowest eye sees the topmost pixel of each lens
      ASSERT_EQ(epi.pixel(eye, lens)[1], panel.picture.pixel(7 * 11 + 3, 7 * lens + eye)[1]) << lens << " " << eye;
}

// The viewing distance is infinite, so an eye of slope t sees a point at depth z at x - z t. Neighbouring eyes differ
// in slope by pixel / gap = (1/9 mm) / 2 mm = 1/18.
TEST(EpipolarImage, slope_of_lines_follows_depth) {
  for (const double z : {-9.0, -4.0, 4.0, 9.0}) {
    const RenderedPanel panel = test::record(test::sheet(), z, [](Vec2d p) { return Vec3f(std::exp(-p.x * p.x / 2.0)); });
    const Image epi = epipolar_row(panel, 60, SampleFilter::kLinear);
    const auto place = [&](int eye) {
      double sum = 0.0, weight = 0.0;
      for (int x = 0; x < epi.width; ++x) sum += epi.pixel(x, eye)[0] * (x - 19.5), weight += epi.pixel(x, eye)[0];
      return sum / weight;
    };
    for (int eye = 0; eye < 9; ++eye) EXPECT_NEAR(place(eye), -z * (eye - 4) / 18.0, 0.02) << z << " " << eye;
  }
}

TEST(EpipolarImage, cancelling_stops_before_the_next_eye) {
  const RenderedPanel panel = noise(test::lenslets(100.0f));
  Context context;
  context.cancelled = true;
  for (const auto& line : {epipolar_row, epipolar_column}) {
    const Image whole = line(panel, 4, SampleFilter::kLinear, {}), black(whole.width, whole.height, 3);
    EXPECT_NE(whole.data, black.data);
    EXPECT_EQ(line(panel, 4, SampleFilter::kLinear, context).data, black.data);
  }
}

TEST(EpipolarImage, missing_lines_are_refused) {
  const RenderedPanel panel = noise(test::sheet());
  const auto of_row = [&](int row) { return test::error_message([&] { epipolar_row(panel, row, SampleFilter::kLinear); }); };
  EXPECT_THAT(of_row(-1), testing::HasSubstr("no row -1"));
  EXPECT_THAT(of_row(120), testing::HasSubstr("0 to 119"));
  EXPECT_THAT(test::error_message([&] { epipolar_column(panel, 0, SampleFilter::kLinear); }),
              testing::HasSubstr("no vertical parallax"));
}

}  // namespace
}  // namespace lippmann
