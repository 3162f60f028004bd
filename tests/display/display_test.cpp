#include "lippmann/display/display.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

TEST(Display, viewer_stands_where_the_panel_spans_14_degrees) {
  // The Portrait is 2048 pixels / 324 dpi = 160.55 mm high. Without a stated viewing distance, the viewer sees this
  // height under 14 degrees: distance = (160.55 mm / 2) / tan(7 degrees) = 653.80 mm.
  EXPECT_NEAR(viewing_distance_mm(load_display("portrait")), 653.80, 0.01);
  Display display;
  display.viewing_distance_mm = 400.0;
  EXPECT_EQ(viewing_distance_mm(display), 400.0);
}

TEST(Display, lenticular_sheet_converges_to_the_viewer) {
  // lens pitch: 25.4 mm / 60 = 0.42333 mm
  const Display display = load_display("lenticular-60lpi-720dpi");
  const Optics optics = native_optics(display);
  const auto& sheet = std::get<LenticularSheet>(optics.model);
  EXPECT_NEAR(sheet.lens_pitch_mm, 0.423333, 1e-6);
  EXPECT_NEAR(degrees(viewing_zone(optics)), 54.0, 1e-3);
  EXPECT_NEAR(sheet.viewing_distance_mm, 101.6 / std::tan(radians(7.0f)), 1e-2);
  EXPECT_EQ(views_of(display), 12);
}

TEST(Display, microlens_array_has_square_or_hexagonal_lenses) {
  const auto packing = [](const char* name) {
    return std::get<MicrolensArray>(native_optics(load_display(name)).model).packing;
  };
  EXPECT_EQ(packing("microlens-1mm-4k"), LensPacking::kSquare);
  EXPECT_EQ(packing("microlens-1mm-hexagonal-4k"), LensPacking::kHexagonal);
  // 1 mm / (25.4 mm / 282.4) = 11.1 pixels per lens, so 11 x 11 views
  EXPECT_EQ(views_of(load_display("microlens-1mm-4k")), 121);
}

TEST(Display, quilts_tiles_are_stretched_to_the_display) {
  // Tiles of 4092 / 11 = 372 by 4092 / 6 = 682 pixels cover 74.4929 x 132.4318 mm, so a pixel measures 0.200250 x
  // 0.194181 mm.
  const Optics quilt = quilt_optics(load_display("go")).value();
  EXPECT_NEAR(quilt.panel.pixel_pitch_mm, 0.200250, 1e-6);
  EXPECT_NEAR(std::get<MultiView>(quilt.model).pixel_height, 0.969697, 1e-6);
  EXPECT_NEAR(window_size_mm(quilt).x, 74.4929, 1e-4);
  EXPECT_NEAR(window_size_mm(quilt).y, 132.4318, 1e-4);
  EXPECT_FALSE(quilt_optics(load_display("microlens-1mm-4k")).has_value());
}

TEST(Display, views_follow_the_quilt_or_the_lens) {
  Display display = load_display("portrait");
  EXPECT_EQ(views_of(display), 48);
  display.quilt.reset();
  EXPECT_EQ(views_of(display), 18);  // sub-pixels per lens: 3 * 1536 / 244.04 = 18.88
}

}  // namespace
}  // namespace lippmann
