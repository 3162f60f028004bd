#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const std::string& line) {
  return test::error_message([&] { load_display(line); });
}

TEST(SheetLine, prints_the_given_pitch_without_a_viewing_distance) {
  const Display sheet = load_display("lpi=60.12 dpi=600 paper=3593x2783px");
  EXPECT_EQ(sheet.kind, DisplayKind::kLenticularSheet);
  EXPECT_EQ(sheet.pixels, Vec2i(3593, 2783));
  EXPECT_NEAR(lens_strips(sheet).cell_px, 600.0 / 60.12, 1e-12);
  EXPECT_EQ(lens_strips(sheet).start_px, 0.0);
  EXPECT_NEAR(lens_strips(load_display("lenses-per-mm=2 dpi=254 paper=A6")).cell_px, 5.0, 1e-12);
  EXPECT_NEAR(lens_strips(load_display("pitch-mm=0.5,dpi=254,paper=A6")).cell_px, 5.0, 1e-12);
}

TEST(SheetLine, papers) {
  const auto pixels = [](const std::string& paper) { return load_display("lpi=50 dpi=254 paper=" + paper).pixels; };
  EXPECT_EQ(pixels("A5"), Vec2i(1480, 2100));
  EXPECT_EQ(pixels("a5 landscape"), Vec2i(2100, 1480));
  EXPECT_EQ(pixels("Letter"), Vec2i(2159, 2794));
  EXPECT_EQ(pixels("148x210mm"), Vec2i(1480, 2100));
  EXPECT_EQ(pixels("5x7in"), Vec2i(1270, 1778));
  EXPECT_EQ(load_display("lpi=60.12 dpi=360.72 paper=5.98833x4.63833in").pixels, Vec2i(2160, 1673));
  EXPECT_EQ(load_display("lpi=60 dpi=1440 paper=42x10mm").pixels.x, 2381);
}

// c is the width in mm of the print below a lens. The viewing angle is 2 atan(1/2), so the gap between lenses and print equals
// c. The lenses are 0.5 mm apart and the eye is at 500 mm. By similar triangles, c / 0.5 = (500 + c) / 500, so c = 250 / 499.5.
TEST(SheetLine, near_viewers_need_a_wider_print) {
  const double angle = 2.0 * std::atan(0.5) * 180.0 / std::numbers::pi;
  const std::string rest = " dpi=2540 paper=A6 viewing-distance=500 view-angle=" + std::to_string(angle);
  const Display lenses = load_display("pitch-mm=0.5" + rest);
  EXPECT_EQ(lenses.lenses.pitch_mm, 0.5);
  EXPECT_NEAR(lens_strips(lenses).cell_px, 250.0 / 499.5 * 100.0, 1e-6);
  const Display measured = load_display("visual-lpi=" + std::to_string(25.4 * 499.5 / 250.0) + rest);
  EXPECT_NEAR(lens_strips(measured).cell_px, 250.0 / 499.5 * 100.0, 1e-5);
  EXPECT_NEAR(measured.lenses.pitch_mm, 0.5, 1e-6);
  EXPECT_THAT(measured.description, AllOf(HasSubstr("print pitch of 50.749 lpi"), HasSubstr("lenses of 50.800 lpi")));
}

TEST(SheetLine, optics_have_a_lens_edge_at_phase) {
  const Display sheet = load_display("lpi=60.12 dpi=600 paper=400x300px phase=3.25");
  const Optics optics = native_optics(sheet);
  const double cell = 600.0 / 60.12;
  for (const double lens : {3.0, 17.0, 30.0}) {
    const double edge = 3.25 + lens * cell;
    const auto slope = [&](double x) {
      const Vec3f direction = ray_of_pixel(optics, Vec2f(x, 150.5)).direction;
      return direction.x / direction.z;
    };
    EXPECT_GT(slope(edge + 0.01), 0.3) << "the left of a strip is seen from the right";
    EXPECT_LT(slope(edge - 0.01), -0.3);
  }
}

TEST(SheetLine, errors_name_the_key_and_accepted_values) {
  EXPECT_THAT(refusal("lpi=0 dpi=600 paper=A5"), HasSubstr("lpi"));
  EXPECT_THAT(refusal("lpi=60 paper=A5"), AllOf(HasSubstr("dpi"), HasSubstr("is missing")));
  EXPECT_THAT(refusal("dpi=60 paper=A5"), AllOf(HasSubstr("lpi"), HasSubstr("pitch-mm")));
  EXPECT_THAT(refusal("lpi=60 dpi=600 paper=A9"), AllOf(HasSubstr("'A9'"), HasSubstr("A0 to A8, letter")));
  EXPECT_THAT(refusal("lpi=60 dpi=600"), AllOf(HasSubstr("paper"), HasSubstr("148x210mm")));
  EXPECT_THAT(refusal("lpi=60 dpi=600 papre=A5"), HasSubstr("'paper'"));
  EXPECT_THAT(refusal("lpi=60 pitch-mm=0.4 dpi=600 paper=A5"), HasSubstr("cannot be combined with `lpi`"));
  EXPECT_THAT(refusal("lpi=60 lpi=61 dpi=600 paper=A5"), HasSubstr("twice"));
  EXPECT_THAT(refusal("visual-lpi=60 dpi=600 paper=A5"), HasSubstr("viewing-distance"));
  EXPECT_THAT(refusal("lpi=350 dpi=600 paper=A5"), HasSubstr("lenses 1.714 pixels wide"));
  EXPECT_THAT(refusal("lpi=1 dpi=600 paper=20x20mm"), HasSubstr("lenses 600.000 pixels wide on a print of 472 pixels"));
  EXPECT_THAT(refusal("lpi=60 dpi=60000 paper=A0"), HasSubstr("65536"));
}

TEST(SheetLine, is_not_a_file) {
  EXPECT_FALSE(is_display_file("lpi=60 dpi=600 paper=A5"));
  EXPECT_FALSE(is_display_file("portrait"));
  EXPECT_TRUE(is_display_file("a=b.TOML"));
  EXPECT_TRUE(is_display_file("folder/visual.json"));
}

TEST(DisplayFile, misplaced_keys_name_their_table) {
  const auto refusal_of = [](const std::string& text) {
    return test::error_message([&] { display_from_toml(text, "own.toml"); });
  };
  const std::string sheet = "kind = \"lenticular-sheet\"\npixels = [400, 300]\n";
  EXPECT_THAT(refusal_of(sheet + "view_cone_deg = 40\nlenses_per_inch = 40\n[lenses]\n"), HasSubstr("[lenses]"));
  EXPECT_THAT(refusal_of(sheet + "view_cone_deg = 40\n[lenses]\nlenses_per_inch = 40\ndpi = 300\n"),
              AllOf(HasSubstr("lenses.dpi"), HasSubstr("the top of the file")));
}

}  // namespace
}  // namespace lippmann
