#include "sheet/lens_heights.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

LensSpec thickness(double mm) {
  LensSpec spec;
  spec.thickness_mm = mm;
  return spec;
}

/// A sheet with lenses of 24 pixels. The viewer is so far away that the printed strips are as wide as the lenses.
Display sheet_of_whole_pixels() { return load_display("lpi=60 dpi=1440 paper=240x6px viewing-distance=10000000"); }

TEST(LensShapes, radius_follows_from_thickness_and_index) {
  // Radius: r = thickness (index - 1) / index = 0.9 (1.5 - 1) / 1.5 = 0.3 mm. Height of the cap: s = 0.3 - sqrt(0.3^2 -
  // 0.2^2) = 0.0763932 mm. Half angle b: sin b = 1.5 sin(atan(0.2 / 0.9)), so b = 18.9895 degrees.
  const LensShape shape = lens_shape(0.4, thickness(0.9));
  EXPECT_NEAR(shape.radius_mm, 0.3, 1e-12);
  EXPECT_NEAR(shape.height_mm, 0.07639320225, 1e-10);
  EXPECT_NEAR(shape.thickness_mm, 0.9, 1e-12);
  EXPECT_NEAR(shape.view_angle_deg, 37.979, 1e-3);
}

TEST(LensShapes, height_and_radius_give_the_same_cap) {
  LensSpec by_height, by_radius;
  // The radius is (half width^2 + height^2) / (2 height) = (0.2^2 + 0.1^2) / 0.2 = 0.25 mm.
  by_height.height_mm = 0.1, by_radius.radius_mm = 0.25;
  EXPECT_NEAR(lens_shape(0.4, by_height).radius_mm, 0.25, 1e-12);
  EXPECT_NEAR(lens_shape(0.4, by_radius).height_mm, 0.1, 1e-12);
}

TEST(LensShapes, more_than_half_a_cylinder_is_refused) {
  LensSpec spec;
  EXPECT_THAT(error_message([&] { lens_shape(0.4, spec); }), HasSubstr("the shape of the lenses is unknown"));
  spec.radius_mm = 0.19;
  EXPECT_THAT(error_message([&] { lens_shape(0.4, spec); }), HasSubstr("at least 0.2"));
  spec.height_mm = 0.1;
  EXPECT_THAT(error_message([&] { lens_shape(0.4, spec); }), HasSubstr("conflicts with the other values"));
  spec = {};
  spec.height_mm = 0.21;
  EXPECT_THAT(error_message([&] { lens_shape(0.4, spec); }), HasSubstr("at most 0.2"));
  EXPECT_THAT(error_message([&] { lens_shape(0.4, thickness(0.5)); }), HasSubstr("at least 0.6000 for the index 1.5"));
}

TEST(LensHeights, follow_a_cylinder) {
  const ThreadPool pool(2);
  const Display sheet = sheet_of_whole_pixels();
  const LensShape shape = lens_shape(sheet.lenses.pitch_mm, thickness(0.9));
  const HeightMap map = lens_heights(sheet, shape, pool);
  ASSERT_EQ(map.codes.size(), 240u * 6u);
  const double edge = std::sqrt(0.09 - std::pow(25.4 / 120.0, 2));
  for (int x = 0; x < 240; ++x) {
    const double from_axis = (x % 24 - 11.5) * 25.4 / 1440.0;
    const double expected = 65535.0 * (std::sqrt(0.09 - from_axis * from_axis) - edge) / (0.3 - edge);
    // The viewer is 10 km away, so the printed strips are as wide as the lenses within 1e-7. This changes heights by at
    // most one code.
    EXPECT_NEAR(map.codes[static_cast<std::size_t>(x)], expected, 1.0) << x;
    EXPECT_EQ(map.codes[static_cast<std::size_t>(x) + 240 * 5], map.codes[static_cast<std::size_t>(x)]);
  }
}

// Lenses are narrower than the strips below them, so there are fewer strips than lenses.
TEST(LensHeights, lenses_have_the_pitch_of_the_sheet) {
  const ThreadPool pool(1);
  const Display sheet = load_display("lpi=20 dpi=400 paper=4000x2px viewing-distance=60");
  const LensShape shape = lens_shape(sheet.lenses.pitch_mm, thickness(3.0));
  const HeightMap map = lens_heights(sheet, shape, pool);
  int edges = 0;
  for (std::size_t x = 1; x + 1 < 4000; ++x)
    if (map.codes[x] < map.codes[x - 1] && map.codes[x] <= map.codes[x + 1]) ++edges;
  const double strips = 4000.0 / lens_strips(sheet).cell_px;
  EXPECT_LT(strips, 196.0);
  EXPECT_NEAR(edges, 200, 1) << "4000 pixels of 1/400 inch, 20 lenses per inch";
}

TEST(LensHeights, slanted_lenses_do_not_depend_on_threads) {
  const Display sheet = load_display("lpi=20 dpi=400 paper=300x200px slant=12");
  const auto made = [&](int threads) {
    const ThreadPool pool(threads);
    return lens_heights(sheet, lens_shape(sheet.lenses.pitch_mm, thickness(3.0)), pool).codes;
  };
  const auto one = made(1);
  EXPECT_EQ(one, made(3));
  EXPECT_FALSE(std::equal(one.begin(), one.begin() + 300, one.begin() + 300 * 50));
}

}  // namespace
}  // namespace lippmann
