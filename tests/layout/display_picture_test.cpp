// Most views in these tests are uniform, so a pixel's colour identifies its view.
#include "lippmann/layout/display_picture.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>

#include "layout/light_fields.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/convert.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

Image8 plain(Vec2i size, unsigned char r, unsigned char g, unsigned char b) {
  Image8 image{size.x, size.y, {}};
  for (int i = 0; i < size.x * size.y; ++i) image.rgb.insert(image.rgb.end(), {r, g, b});
  return image;
}

/// Returns views of uniform colour. View k has the red code 20 k + 10.
LightField plain_views(int count, Vec2i size, const Display& display, DisplayTarget target, const ThreadPool& pool) {
  ViewFitter fitter(display, target, AspectFit::kCrop, pool);
  LightField field;
  field.grid = {count, 1};
  for (int view = 0; view < count; ++view) {
    const Picture fitted =
        fitter.fitted(plain(size, static_cast<unsigned char>(20 * view + 10), 0, 255), static_cast<double>(size.x) / size.y);
    if (view == 0) field.view_size = size_of(fitted), field.stack = blank(fitted, stack_size(field));
    set_view(field, view, fitted);
  }
  return field;
}

int view_at(const Picture& picture, int x, int y) {
  const auto& image = std::get<Image8>(picture);
  return (image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x))] -
          10) /
         20;
}

Picture print_of(int count, Vec2i size, const std::string& line, const DisplayPictureParams& params = {}) {
  const ThreadPool pool(2);
  const Display sheet = load_display(line);
  return display_picture(plain_views(count, size, sheet, DisplayTarget::kIntegral, pool), sheet, DisplayTarget::kIntegral,
                         params, pool);
}

TEST(DisplayPicture, six_photos_with_a_fractional_pitch) {
  const Picture print = print_of(6, {3512, 2422}, "lpi=60.12 dpi=600 paper=3593x2783px");
  ASSERT_EQ(size_of(print), Vec2i(3593, 2783));
  std::map<int, int> pixels;
  int lenses = 1;
  for (int x = 0; x < 3593; ++x) {
    ++pixels[view_at(print, x, 1000)];
    if (x > 0 && view_at(print, x, 1000) > view_at(print, x - 1, 1000)) ++lenses;
  }
  EXPECT_EQ(lenses, 360);
  for (int view = 0; view < 6; ++view) EXPECT_NEAR(pixels[view] / 3593.0, 1.0 / 6.0, 0.003) << view;
  for (int x = 0; x < 9; ++x) EXPECT_GE(view_at(print, x, 0), view_at(print, x + 1, 0)) << "mirrored below a lens";
}

TEST(DisplayPicture, whole_pitch_has_one_column_per_view) {
  const Picture print = print_of(6, {351, 242}, "lpi=60.12 dpi=360.72 paper=5.98833x4.63833in");
  ASSERT_EQ(size_of(print), Vec2i(2160, 1673));
  for (int x = 0; x < 2160; ++x) ASSERT_EQ(view_at(print, x, 7), 5 - x % 6) << x;
}

TEST(DisplayPicture, ten_frames_of_a_flip_print) {
  DisplayPictureParams flip;
  flip.flip = FlipParams{};
  // A lens is 9.56 pixels wide, and each of the 10 frames covers 0.956 = 239/250 pixels of it. With phase=0.5, the
  // centre of pixel x is x pixels from the left edge of the first lens.
  const Picture print = print_of(10, {64, 8}, "pitch-mm=0.33725555555555556 dpi=720 paper=1434x20px phase=0.5", flip);
  for (int x = 0; x < 1434; ++x) ASSERT_EQ(view_at(print, x, 3), 250 * x % 2390 / 239) << x;
}

TEST(DisplayPicture, two_pictures_get_twelve_pixels_each) {
  const Picture print = print_of(2, {50, 20}, "lpi=60 dpi=1440 paper=42x1mm");
  ASSERT_EQ(size_of(print).x, 2381);
  for (int x = 0; x < 2381; ++x) ASSERT_EQ(view_at(print, x, 0), x % 24 < 12 ? 1 : 0) << x;
}

TEST(DisplayPicture, flip_shares_and_soft_transitions) {
  DisplayPictureParams flip;
  flip.flip = FlipParams{{2.0, 1.0, 1.0}, 0.0};
  const std::string line = "pitch-mm=1 dpi=1016 paper=80x4px";  // a lens covers 40 pixels
  const Picture hard = print_of(3, {8, 4}, line, flip);
  for (int x = 0; x < 80; ++x) EXPECT_EQ(view_at(hard, x, 0), x % 40 < 20 ? 0 : x % 40 < 30 ? 1 : 2) << x;
  // The smallest of a lens's three shares is 10 pixels, so neighbouring views blend over 0.4 * 10 = 4 pixels.
  flip.flip->blend = 0.4;
  const Picture soft = print_of(3, {8, 4}, line, flip);
  const auto red = [&](int x) { return int{std::get<Image8>(soft).rgb[3 * static_cast<std::size_t>(x)]}; };
  EXPECT_EQ(red(17), 10);
  EXPECT_GT(red(18), 10);
  EXPECT_LT(red(21), 30);
  EXPECT_EQ(red(22), 30);
  EXPECT_GT(red(30), red(29));
  EXPECT_THAT(test::error_message([&] { print_of(4, {8, 4}, line, flip); }), HasSubstr("3 shares for 4 frames"));
}

TEST(DisplayPicture, linear_filter_ramps_between_views) {
  DisplayPictureParams linear;
  linear.filter = ViewFilter::kLinear;
  const Picture print = print_of(2, {8, 4}, "pitch-mm=1 dpi=1016 paper=40x4px", linear);
  const auto& image = std::get<Image8>(print);
  EXPECT_EQ(image.rgb[0], 30);
  EXPECT_EQ(image.rgb[3 * 39], 10);
  for (std::size_t x = 0; x < 39; ++x) EXPECT_GE(image.rgb[3 * x], image.rgb[3 * x + 3]);
  EXPECT_GT(image.rgb[3 * 19], 10);
  EXPECT_LT(image.rgb[3 * 19], 30);
}

// With tan(slant) = 1/4, the pattern moves by one pixel in four rows.
TEST(DisplayPicture, slanted_lenses_shift_from_row_to_row) {
  const std::string line = "pitch-mm=1 dpi=1016 paper=200x100px slant=14.0362434679";  // tan(slant) = 1/4
  const Picture print = print_of(8, {8, 4}, line);
  for (int y = 0; y + 4 < 100; y += 4)
    for (int x = 0; x < 199; ++x) ASSERT_EQ(view_at(print, x, y), view_at(print, x + 1, y + 4)) << x << ", " << y;
}

TEST(DisplayPicture, photos_become_the_quilt_of_the_go) {
  const test::TempDir dir;
  std::filesystem::create_directories(dir / "in");
  for (int view = 0; view < 66; ++view)
    write_picture(dir / ("in/view_" + std::string(view < 10 ? "0" : "") + std::to_string(view) + ".png"),
                  plain({40, 30}, static_cast<unsigned char>(100 + view), 200, 50));
  ConvertParams params{.from = "views", .to = "quilt"};
  params.options.display = load_display("go");
  params.display_picture = DisplayPictureParams{};
  const Converted made = convert(dir / "in", dir / "go.png", params);
  ASSERT_EQ(made.written.front().filename(), "go_qs11x6a0.5625.png");
  EXPECT_EQ(made.fitted, "cropped from 40x30 to 17x30, resized to 372x682");
  const auto quilt = std::get<Image8>(read_picture(made.written.front()));
  ASSERT_EQ(Vec2i(quilt.width, quilt.height), Vec2i(4092, 4092));
  const auto red = [&](int x, int y) {
    return int{quilt.rgb[3 * (static_cast<std::size_t>(y) * 4092 + static_cast<std::size_t>(x))]};
  };
  for (int x = 0; x < 4092; ++x) {
    ASSERT_EQ(red(x, 0), 155 + x / 372) << "the first row: views 55 to 65";
    ASSERT_EQ(red(x, 4091), 100 + x / 372) << "the last row: views 0 to 10";
  }
}

TEST(DisplayPicture, each_eye_gets_half_the_panel) {
  const Display panel = display_from_calibration(
      R"({"pitch": {"value": 52.59267044067383}, "slope": {"value": -7.083540916442871}, "center": {"value": 0.8167931437492371},
          "screenW": {"value": 1536}, "screenH": {"value": 2048}, "DPI": {"value": 324}})",
      "visual.json");
  EXPECT_NEAR(periods_of(panel), 246.8802, 5e-5);
  EXPECT_NEAR(tilt_of(panel), -0.188230, 5e-7);
  const SlantedPanel lenses = slanted_panel(panel, 300.0);
  // Red sub-pixels are a third of a pixel to the left of the pixel's centre.
  const double z = (0.5 + 0.5 * lenses.tilt - 1.0 / (3 * 1536)) * lenses.periods - lenses.center;
  EXPECT_NEAR(1.0 - (z - std::floor(z)), 0.6118, 5e-5);
  const ThreadPool pool(2);
  ViewFitter fitter(panel, DisplayTarget::kNative, AspectFit::kCrop, pool);
  LightField pair;
  pair.grid = {2, 1}, pair.view_size = {300, 400};
  const Picture red = fitter.fitted(plain({400, 400}, 255, 0, 0), 1.0), blue = fitter.fitted(plain({400, 400}, 0, 0, 255), 1.0);
  pair.view_size = size_of(red), pair.stack = blank(red, stack_size(pair));
  set_view(pair, 0, red), set_view(pair, 1, blue);
  const auto frame = std::get<Image8>(display_picture(pair, panel, DisplayTarget::kNative, {}, pool));
  double left = 0.0, right = 0.0;
  for (std::size_t i = 0; i < frame.rgb.size(); i += 3) left += frame.rgb[i] == 255, right += frame.rgb[i + 2] == 255;
  const double pixels = 1536.0 * 2048.0;
  EXPECT_NEAR(left / pixels, 0.5, 0.002);
  EXPECT_NEAR(right / pixels, 0.5, 0.002);
}

TEST(DisplayPicture, microlenses_show_views_across_and_up) {
  const Display array = display_from_toml(
      "kind = \"microlens-array\"\npixels = [40, 40]\ndpi = 254\nview_cone_deg = 30\n[lenses]\npitch_mm = 0.397\n",
      "array.toml");
  const ThreadPool pool(2);
  ViewFitter fitter(array, DisplayTarget::kIntegral, AspectFit::kCrop, pool);
  LightField field;
  field.grid = {2, 2}, field.view_size = fitter.size();
  field.stack = plain(stack_size(field), 0, 0, 0);
  for (int view = 0; view < 4; ++view)
    set_view(field, view, plain(field.view_size, static_cast<unsigned char>(20 * view + 10), 0, 0));
  const Picture picture = display_picture(field, array, DisplayTarget::kIntegral, {}, pool);
  // Four lenses meet in the middle of the picture. The top left pixel of a lens is seen from the lower right: view 1.
  EXPECT_EQ(view_at(picture, 20, 20), 1);
  EXPECT_EQ(view_at(picture, 19, 20), 0);
  EXPECT_EQ(view_at(picture, 20, 19), 3);
}

TEST(DisplayPicture, mirrored_and_turned) {
  const std::string line = "pitch-mm=1 dpi=101.6 paper=8x6px";  // a lens covers 4 pixels
  const Picture print = print_of(4, {8, 6}, line);
  DisplayPictureParams params;
  params.mirror = true;
  const Picture mirrored = print_of(4, {8, 6}, line, params);
  for (int x = 0; x < 8; ++x) EXPECT_EQ(view_at(mirrored, x, 2), view_at(print, 7 - x, 2));
  params.mirror = false, params.turn_deg = 90;
  const Picture turned = print_of(4, {8, 6}, line, params);
  ASSERT_EQ(size_of(turned), Vec2i(6, 8));
  for (int y = 0; y < 8; ++y) EXPECT_EQ(view_at(turned, 3, y), view_at(print, y, 2)) << "the left goes to the top";
}

TEST(DisplayPicture, same_for_any_number_of_threads) {
  const Display sheet = load_display("lpi=60.12 dpi=600 paper=211x97px slant=9.5");
  const auto made_with = [&](int threads) {
    const ThreadPool pool(threads);
    LightField field = test::numbered_field({5, 1}, {83, 61});
    ViewFitter fitter(sheet, DisplayTarget::kIntegral, AspectFit::kPad, pool);
    fitter.fit(field);
    DisplayPictureParams params;
    params.filter = ViewFilter::kLinear;
    return display_picture(field, sheet, DisplayTarget::kIntegral, params, pool);
  };
  EXPECT_TRUE(test::same_samples(made_with(1), made_with(4)));
}

/// Returns a texture that moves to the right by two pixels from view to view.
Image8 moving_view(int view) {
  Image8 image = plain({40, 30}, 0, 0, 90);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      image.rgb[3 * static_cast<std::size_t>(40 * y + x)] =
          static_cast<unsigned char>(1 + (37 * (x - 2 * view + 8) + 11 * y) % 255);
  return image;
}

TEST(DisplayPicture, view_shift_cancels_motion_between_views) {
  // a sheet with 36 lenses and an aspect ratio of 4:3
  const Display sheet = load_display("pitch-mm=1 dpi=254 paper=360x270px");
  const ThreadPool pool(1);
  ViewFitter fitter(sheet, DisplayTarget::kIntegral, AspectFit::kCrop, pool, 2.0);
  const ViewGrid grid{3, 1};
  const Picture left = fitter.fitted(moving_view(0), 4.0 / 3.0, 0, grid);
  EXPECT_EQ(fitter.description(), "cropped from 40x30 to 36x27, shifted by 2 pixels from view to view, resized to 36x270");
  for (int view = 1; view < 3; ++view)
    EXPECT_TRUE(test::same_samples(fitter.fitted(moving_view(view), 4.0 / 3.0, view, grid), left)) << view;
}

TEST(DisplayPicture, shift_of_rows_moves_the_window_up) {
  const Display array = display_from_toml(
      "kind = \"microlens-array\"\npixels = [40, 40]\ndpi = 254\nview_cone_deg = 30\n[lenses]\npitch_mm = 0.4\n", "array.toml");
  const ThreadPool pool(1);
  ViewFitter fitter(array, DisplayTarget::kIntegral, AspectFit::kCrop, pool, 3.0);
  Image8 view = plain({33, 33}, 0, 0, 0);
  for (int y = 0; y < 33; ++y)
    for (int x = 0; x < 33; ++x)
      view.rgb[3 * static_cast<std::size_t>(33 * y + x)] = static_cast<unsigned char>(y < 3 ? 200 : 0);
  const auto red = [&](int row) { return int{std::get<Image8>(fitter.fitted(view, 1.0, row, {1, 2})).rgb[0]}; };
  EXPECT_EQ(red(0), 0) << "rows 3 to 33";
  EXPECT_EQ(red(1), 200) << "rows 0 to 30";
}

TEST(DisplayPicture, shifted_views_show_edges_only_if_padded) {
  const Display go = load_display("go");
  const ThreadPool pool(1);
  const auto darkest = [&](AspectFit fit, int view) {
    ViewFitter fitter(go, DisplayTarget::kQuilt, fit, pool, 3.0);
    const auto fitted = std::get<Image8>(fitter.fitted(plain({90, 160}, 200, 200, 200), 90.0 / 160.0, view, {3, 1}));
    return int{*std::min_element(fitted.rgb.begin(), fitted.rgb.end())};
  };
  for (const int view : {0, 1, 2}) {
    EXPECT_EQ(darkest(AspectFit::kCrop, view), 200) << view;
    EXPECT_EQ(darkest(AspectFit::kStretch, view), 200) << view;
  }
  EXPECT_EQ(darkest(AspectFit::kPad, 0), 0);
  EXPECT_EQ(darkest(AspectFit::kPad, 1), 200);
  EXPECT_EQ(darkest(AspectFit::kPad, 2), 0);
}

TEST(DisplayPicture, shift_counts_the_views_that_are_kept) {
  const test::TempDir dir;
  std::filesystem::create_directories(dir / "all");
  std::filesystem::create_directories(dir / "some");
  for (int view = 0; view < 5; ++view) {
    write_picture(dir / ("all/view_" + std::to_string(view) + ".png"), moving_view(view));
    if (view % 2 == 1) write_picture(dir / ("some/view_" + std::to_string(view / 2) + ".png"), moving_view(view));
  }
  ConvertParams params{.from = "views", .to = "integral"};
  params.options.display = load_display("pitch-mm=1 dpi=254 paper=360x270px");
  params.display_picture = DisplayPictureParams{};
  params.display_picture->view_shift_px = 4.0;
  convert(dir / "some", dir / "some.png", params);
  params.keep = read_kept_views("1-3:2", "keep");
  convert(dir / "all", dir / "all.png", params);
  EXPECT_TRUE(test::same_samples(read_picture(dir / "some.png"), read_picture(dir / "all.png")));
}

TEST(DisplayPicture, padded_views_have_black_bars) {
  const ThreadPool pool(1);
  const Display go = load_display("go");
  ViewFitter fitter(go, DisplayTarget::kQuilt, AspectFit::kPad, pool);
  const auto view = std::get<Image8>(fitter.fitted(plain({90, 80}, 200, 200, 200), 90.0 / 80.0));
  ASSERT_EQ(Vec2i(view.width, view.height), Vec2i(372, 682));
  const auto red = [&](int y) { return int{view.rgb[3 * static_cast<std::size_t>(y) * 372]}; };
  EXPECT_EQ(red(0), 0);
  EXPECT_EQ(red(169), 0);
  EXPECT_EQ(red(172), 200);
  EXPECT_EQ(red(509), 200);
  EXPECT_EQ(red(681), 0);
  EXPECT_EQ(fitter.description(), "padded from 90x80 to 90x160, resized to 372x682");
}

TEST(DisplayPicture, refuses_what_makes_no_print) {
  EXPECT_THAT(test::error_message([] {
                print_of(1, {8, 4}, "pitch-mm=1 dpi=1016 paper=80x4px");
              }),
              HasSubstr("2 or more pictures"));
  EXPECT_THAT(test::error_message([] { display_target(load_display("portrait"), "integral"); }), HasSubstr("native or quilt"));
  EXPECT_THAT(test::error_message([] { display_target(load_display("lenticular-60lpi-600dpi"), "quilt"); }),
              HasSubstr("has no quilt"));
  const ThreadPool pool(1);
  const Display go = load_display("go");
  ViewFitter fitter(go, DisplayTarget::kQuilt, AspectFit::kCrop, pool);
  fitter.fitted(plain({90, 80}, 1, 1, 1), 1.0);
  EXPECT_THAT(test::error_message([&] { fitter.fitted(plain({90, 81}, 1, 1, 1), 1.0); }), HasSubstr("90x81"));
  ViewFitter shifted(go, DisplayTarget::kQuilt, AspectFit::kCrop, pool, -24.0);
  EXPECT_THAT(test::error_message([&] {
                shifted.fitted(plain({90, 80}, 1, 1, 1), 1.0, 0, {3, 1});
              }),
              HasSubstr("view-shift: -24 pixels from view to view leave less than half"));
}

TEST(DisplayPicture, few_pixels_for_the_lenses_are_reported) {
  const ThreadPool pool(2);
  const Display sheet = load_display("lpi=60 dpi=600 paper=4x3in");
  const auto coarseness = [&](Vec2i size) {
    ViewFitter fitter(sheet, DisplayTarget::kIntegral, AspectFit::kCrop, pool);
    fitter.fitted(plain(size, 1, 2, 3), static_cast<double>(size.x) / size.y);
    return fitter.coarseness();
  };
  EXPECT_EQ(coarseness({124, 93}), "") << "240 lenses";
  EXPECT_EQ(coarseness({116, 87}), "the views have 116 pixels across for 240 lenses");
  EXPECT_EQ(coarseness({176, 66}), "the views have 88 pixels across for 240 lenses") << "after cropping";
}

/// Converts an integral image of 8 x 1 views to a folder of views, and makes prints of both.
TEST(DisplayPicture, folders_of_views_keep_the_shape_of_pixels) {
  const test::TempDir dir;
  const LightField field = [] {
    LightField views = test::numbered_field({8, 1}, {16, 128});
    views.aspect = 1.0;
    return views;
  }();
  find_format("integral", "to").write(field, dir / "in.png", {});
  ConvertParams params{.from = "integral", .to = "views"};
  params.options.views = ViewGrid{8, 1};
  const Converted views = convert(dir / "in.png", dir / "views", params);
  EXPECT_EQ(views.written.back().filename(), "views.json");
  EXPECT_EQ(views_format().read(dir / "views", {}).aspect, 1.0);

  params = {.to = "integral"};
  params.options.display = load_display("lpi=16 dpi=128 paper=1x1in");
  params.options.views = ViewGrid{8, 1};
  params.display_picture = DisplayPictureParams{};
  params.from = "integral";
  convert(dir / "in.png", dir / "a.png", params);
  params.from = "views";
  EXPECT_EQ(convert(dir / "views", dir / "b.png", params).fitted, "") << "not cropped";
  EXPECT_TRUE(test::same_samples(read_picture(dir / "a.png"), read_picture(dir / "b.png")));

  params = {.from = "views", .to = "jpeg-pleno"};
  EXPECT_THAT(convert(dir / "views", dir / "pleno", params).left_out,
              testing::ElementsAre("the shape of the pixels, 8 times as wide as high"));
  params.to = "quilt";
  EXPECT_THAT(convert(dir / "views", dir / "quilt.png", params).left_out, testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(dir / "quilt_qs4x2a1.png"));
}

}  // namespace
}  // namespace lippmann
