// The views are uniform, so the value of every pixel is known.
#include <gmock/gmock.h>

#include <array>

#include "lippmann/display/load_display.hpp"
#include "lippmann/layout/display_picture.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

constexpr const char* kSheet = "lpi=20.3 dpi=254 paper=700x500px";  // 10 pixels per mm

Image8 plain(Vec2i size, unsigned char red) {
  Image8 image{size.x, size.y, {}};
  for (int i = 0; i < size.x * size.y; ++i) image.rgb.insert(image.rgb.end(), {red, 90, 200});
  return image;
}

Image8 print_of(const Display& display, const DisplayPictureParams& params) {
  const ThreadPool pool(2);
  const Display sheet = with_bleed(display, params.finish.bleed_mm);
  ViewFitter fitter(sheet, DisplayTarget::kIntegral, AspectFit::kCrop, pool);
  LightField field;
  field.grid = {4, 1};
  for (int view = 0; view < 4; ++view) {
    const Picture fitted = fitter.fitted(plain({40, 30}, static_cast<unsigned char>(60 * view)), 4.0 / 3.0);
    if (view == 0) field.view_size = size_of(fitted), field.stack = blank(fitted, stack_size(field));
    set_view(field, view, fitted);
  }
  return std::get<Image8>(display_picture(field, sheet, DisplayTarget::kIntegral, params, pool));
}

Image8 finished_print(const PrintFinish& finish, const std::string& line = kSheet) {
  DisplayPictureParams params;
  params.finish = finish;
  return print_of(load_display(line), params);
}

std::array<int, 3> pixel(const Image8& image, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

const std::array<int, 3> kInk{0, 0, 0}, kPaper{255, 255, 255};

/// Returns whether `whole` contains `part` at `corner`, the position of its top left pixel.
testing::AssertionResult has_part(const Image8& whole, const Image8& part, Vec2i corner) {
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (pixel(whole, corner.x + x, corner.y + y) != pixel(part, x, y)) return testing::AssertionFailure() << x << ' ' << y;
  return testing::AssertionSuccess();
}

TEST(PrintFinish, bleed_continues_the_lenses_on_all_sides) {
  for (const char* line : {kSheet, "lpi=20.3 dpi=254 paper=700x500px phase=3.7", "lpi=20.3 dpi=254 paper=700x500px slant=9",
                           "lpi=20.3 dpi=254 paper=700x500px slant=9 phase=3.7"}) {
    const Image8 bare = finished_print({}, line), bled = finished_print({.bleed_mm = 3.0}, line);
    ASSERT_EQ(Vec2i(bled.width, bled.height), Vec2i(760, 560));
    EXPECT_TRUE(has_part(bled, bare, Vec2i(30))) << line;
    EXPECT_NE(pixel(bled, 0, 0), kPaper);
  }
}

TEST(PrintFinish, bleed_keeps_lenses_about_the_centre) {
  Display sheet = load_display("lpi=20.3 dpi=254 paper=700x500px slant=9");
  sheet.lenses.phase_px = {};
  DisplayPictureParams params;
  const Image8 bare = print_of(sheet, params);
  params.finish.bleed_mm = 3.0;
  EXPECT_TRUE(has_part(print_of(sheet, params), bare, Vec2i(30)));
}

TEST(PrintFinish, proof_is_the_middle_inch) {
  const Image8 bare = finished_print({}), proof = finished_print({.proof = true});
  ASSERT_EQ(Vec2i(proof.width, proof.height), Vec2i(254));
  EXPECT_TRUE(has_part(bare, proof, {223, 123}));
  const Image8 small = finished_print({.proof = true}, "lpi=20.3 dpi=254 paper=700x100px");
  EXPECT_EQ(Vec2i(small.width, small.height), Vec2i(254, 100));
  EXPECT_THAT(test::error_message([] { finished_print({.proof = true}, "lpi=20.3 dpi=254 paper=200x100px"); }),
              testing::HasSubstr("not larger than an inch"));
}

TEST(PrintFinish, marks_stand_outside_the_bleed) {
  const Image8 bled = finished_print({.bleed_mm = 3.0}), marked = finished_print({.bleed_mm = 3.0, .marks = true});
  ASSERT_EQ(Vec2i(marked.width, marked.height), Vec2i(960, 760));
  EXPECT_TRUE(has_part(marked, bled, Vec2i(100)));
  for (const int x : {130, 830})
    for (const int y : {50, 700}) EXPECT_EQ(pixel(marked, x, y), kInk) << x << ' ' << y;
  for (const int y : {130, 630})
    for (const int x : {50, 900}) EXPECT_EQ(pixel(marked, x, y), kInk) << x << ' ' << y;
  for (const Vec2i centre : {Vec2i(480, 40), Vec2i(480, 720), Vec2i(40, 380), Vec2i(920, 380)}) {
    EXPECT_EQ(pixel(marked, centre.x, centre.y), kInk);
    EXPECT_EQ(pixel(marked, centre.x + 15, centre.y), kInk) << "the ring";
    EXPECT_EQ(pixel(marked, centre.x + 8, centre.y + 8), kPaper);
  }
  for (const Vec2i empty : {Vec2i(0, 0), Vec2i(959, 759), Vec2i(110, 60), Vec2i(300, 40)})
    EXPECT_EQ(pixel(marked, empty.x, empty.y), kPaper);
}

TEST(PrintFinish, bands_are_black_below_lens_centres) {
  DisplayPictureParams params;
  params.finish = {.bleed_mm = 3.0, .marks = true};
  for (const char* line : {"lpi=25.4 dpi=304.8 paper=840x300px phase=5", "lpi=25.4 dpi=304.8 paper=840x300px"}) {
    const Image8 print = print_of(load_display(line), params);
    const int edge = 120 + 36, phase = std::string(line).find("phase") != std::string::npos ? 5 : 0;  // 12 pixels per mm
    int black = 0;
    for (int x = edge + 24; x < edge + 840 - 24; ++x) {
      const int place = (x - edge - phase + 12) % 12;
      ASSERT_EQ(pixel(print, x, 120 - 24) == kInk, place >= 4 && place < 8) << line << ' ' << x;
      ASSERT_EQ(pixel(print, x, print.height - 120 + 24) == kInk, place >= 4 && place < 8) << line << ' ' << x;
      black += pixel(print, x, 120 - 24) == kInk;
    }
    EXPECT_EQ(black, 264);
  }
}

TEST(PrintFinish, marks_of_proofs_belong_to_its_lenses) {
  const Image8 marked = finished_print({.marks = true}), proof = finished_print({.marks = true, .proof = true});
  ASSERT_EQ(Vec2i(proof.width, proof.height), Vec2i(454));
  for (int x = 130; x < 324; ++x) EXPECT_EQ(pixel(proof, x, 80) == kInk, pixel(marked, x + 223, 80) == kInk) << x;
}

TEST(PrintFinish, turns_and_mirrors_with_the_print) {
  DisplayPictureParams params;
  params.finish = {.marks = true};
  const Image8 upright = print_of(load_display(kSheet), params);
  params.turn_deg = 90, params.mirror = true;
  const Image8 turned = print_of(load_display(kSheet), params);
  ASSERT_EQ(Vec2i(turned.width, turned.height), Vec2i(700, 900));
  for (const Vec2i at : {Vec2i(100, 20), Vec2i(450, 60), Vec2i(310, 85), Vec2i(130, 660)})
    EXPECT_EQ(pixel(turned, 700 - 1 - at.y, 900 - 1 - at.x), pixel(upright, at.x, at.y)) << at.x;
}

TEST(PrintFinish, quilts_and_native_frames_are_no_prints) {
  const ThreadPool pool(1);
  LightField field;
  field.grid = {2, 1}, field.view_size = {4, 4}, field.stack = blank(Image8{}, {4, 8});
  DisplayPictureParams params;
  params.finish.marks = true;
  EXPECT_THAT(
      test::error_message([&] { display_picture(field, load_display("portrait"), DisplayTarget::kNative, params, pool); }),
      testing::HasSubstr("need a print"));
}

}  // namespace
}  // namespace lippmann
