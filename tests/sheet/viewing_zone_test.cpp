#include "sheet/viewing_zone.hpp"

#include <gmock/gmock.h>

#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

TEST(ViewingZone, views_lie_mirrored_below_each_lens) {
  const ThreadPool pool(2);
  const Display sheet = load_display("lpi=20 dpi=100 paper=600x400px");
  const ViewingZoneTest test = viewing_zone_test(sheet, 5, pool);
  const auto& image = std::get<Image8>(test.picture);
  ASSERT_EQ(image.width, 600);
  // The first row of pixels contains no printed numbers. Below each lens, the pixels of the last view, which is blue,
  // are leftmost.
  for (std::size_t x = 0; x < 600; ++x) {
    const bool is_red = image.rgb[3 * x] > image.rgb[3 * x + 2], is_blue = image.rgb[3 * x] < image.rgb[3 * x + 2];
    EXPECT_EQ(is_blue, x % 5 < 2) << x;
    EXPECT_EQ(is_red, x % 5 > 2) << x;
  }
}

TEST(ViewingZone, angles_match_evenly_spaced_eyes) {
  const ThreadPool pool(1);
  const ViewingZoneTest test = viewing_zone_test(load_display("lpi=20 dpi=100 paper=600x400px view-angle=90"), 3, pool);
  ASSERT_EQ(test.angles_deg.size(), 3u);
  EXPECT_NEAR(test.angles_deg[0], -33.690067526, 1e-6);  // eyes are spread evenly over the plane: atan(2/3 * tan(45 degrees))
  EXPECT_NEAR(test.angles_deg[1], 0.0, 1e-12);
  EXPECT_NEAR(test.angles_deg[2], 33.690067526, 1e-6);
}

TEST(ViewingZone, views_are_at_most_the_pixels_below_a_lens) {
  const ThreadPool pool(1);
  EXPECT_EQ(default_zone_views(load_display("lpi=20 dpi=400 paper=600x400px")), 9);
  EXPECT_EQ(default_zone_views(load_display("lpi=20 dpi=130 paper=600x400px")), 3);
  EXPECT_EQ(default_zone_views(load_display("lpi=20 dpi=40 paper=600x400px")), 2);
  EXPECT_THAT(test::error_message([&] { viewing_zone_test(load_display("lpi=20 dpi=100 paper=600x400px"), 6, pool); }),
              testing::HasSubstr("6 views do not fit in 5 pixels"));
}

}  // namespace
}  // namespace lippmann
