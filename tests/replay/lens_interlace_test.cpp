#include "layout/lens_interlace.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <set>

#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "replay/depth_views.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

Display sheet_of_ten() {
  Display sheet;
  sheet.name = "sheet", sheet.kind = DisplayKind::kLenticularSheet;
  sheet.pixels = {80, 6}, sheet.dpi = 25.4, sheet.view_cone_deg = 30.0, sheet.viewing_distance_mm = 1000.0;
  sheet.lenses.pitch_mm = 8.0;
  return sheet;
}

/// Gap g in mm. For a viewer at 1000 mm, the strip below a lens of 8 mm is 8 (1 + g / 1000) mm wide. Seen from the
/// lens, the strip spans 30 degrees, so its width is also 2 g tan(15 degrees).
double gap_mm() { return 8.0 / (2.0 * std::tan(15.0 * std::numbers::pi / 180.0) - 8.0 / 1000.0); }

double cell_mm() { return 8.0 * (1.0 + gap_mm() / 1000.0); }

LightField coded(const Display& display, const std::function<int(int view, int x, int y)>& code) {
  const Optics optics = lens_views(display, {});
  const RenderedViews rendered = *rendered_views(optics);
  LightField field;
  field.grid = rendered.film.grid, field.cameras = rendered.cameras;
  field.view_size = view_size(rendered.film, film_size(optics), "optics");
  Image16 stack{field.view_size.x, field.view_size.y * field.grid.count(), {}};
  for (int v = 0; v < field.grid.count(); ++v)
    for (int y = 0; y < field.view_size.y; ++y)
      for (int x = 0; x < field.view_size.x; ++x)
        stack.rgb.insert(stack.rgb.end(), 3, static_cast<std::uint16_t>(code(v, x, y)));
  field.stack = std::move(stack);
  return field;
}

Image16 behind_lenses(const LightField& field, const Display& display, int threads = 1) {
  const ThreadPool pool(threads);
  return std::get<Image16>(interlace_behind_lenses(field, display, pool));
}

int code_at(const Image16& picture, int x, int y) { return picture.rgb[3 * static_cast<std::size_t>(y * picture.width + x)]; }

TEST(LensInterlace, one_view_per_pixel_below_a_lens) {
  const Optics optics = lens_views(sheet_of_ten(), {});
  EXPECT_EQ(view_tiles(optics)->columns, 9) << "8.12 pixels to a cell";
  EXPECT_EQ(view_tiles(optics)->rows, 1);
  EXPECT_EQ(film_size(optics), Vec2i(90, 6));
  EXPECT_EQ(view_tiles(lens_views(sheet_of_ten(), ViewGrid{20, 1}))->columns, 20);
  EXPECT_THAT(test::error_message([] { lens_views(sheet_of_ten(), ViewGrid{81, 1}); }), testing::HasSubstr("fewer views"));
}

TEST(LensInterlace, pixel_shows_the_view_opposite_to_it) {
  const Image16 picture = behind_lenses(coded(sheet_of_ten(), [](int view, int, int) { return view; }), sheet_of_ten());
  const double cell = cell_mm();
  int compared = 0;
  for (int i = 0; i < 80; ++i) {
    // The cells are the areas below the lenses. An edge of a cell is at x = 0, the middle of the panel. The pixel at
    // the right end of a cell is seen from the left.
    const double x = i + 0.5 - 40.0, share = 1.0 - (x / cell - std::floor(x / cell)), view = 9.0 * share;
    if (std::abs(view - std::round(view)) < 1e-3) continue;  // rounding decides between two views
    EXPECT_EQ(code_at(picture, i, 3), static_cast<int>(view)) << i;
    ++compared;
  }
  EXPECT_GE(compared, 75);
}

TEST(LensInterlace, pixel_shows_the_sample_at_its_lens) {
  const Image16 picture =
      behind_lenses(coded(sheet_of_ten(), [](int, int x, int y) { return 1000 * x + 10 * y; }), sheet_of_ten());
  const double cell = cell_mm();
  // The viewer at V = 1000 mm sees the panel through a window in the plane of the lenses that is V / (V + g) times as
  // wide, with the gap g. The ten samples of a view fill this window.
  const double window = 80.0 * 1000.0 / (1000.0 + gap_mm());
  for (int i = 0; i < 80; ++i) {
    const double lens = 8.0 * (std::floor((i + 0.5 - 40.0) / cell) + 0.5);
    const double column = std::clamp((lens / window + 0.5) * 10.0 - 0.5, 0.0, 9.0);
    for (int y = 0; y < 6; ++y) EXPECT_NEAR(code_at(picture, i, y), 1000.0 * column + 10.0 * y, 1.0) << i << " " << y;
  }
}

TEST(LensInterlace, fractional_slanted_and_hexagonal_lenses_are_filled) {
  Display display = sheet_of_ten();
  const auto brightness = [](int, int, int) { return 4000; };
  display.lenses.slant_deg = 9.46, display.lenses.pitch_mm = 7.3;
  EXPECT_THAT(behind_lenses(coded(display, brightness), display).rgb, testing::Each(4000));
  display.kind = DisplayKind::kMicrolensArray, display.lenses.packing = LensPacking::kHexagonal, display.pixels = {80, 60};
  const LightField field = coded(display, [](int view, int, int) { return view; });
  EXPECT_EQ(field.grid, (ViewGrid{8, 7})) << "rows of lenses are 0.87 of a pitch apart";
  EXPECT_THAT(behind_lenses(coded(display, brightness), display).rgb, testing::Each(4000));
  const Image16 picture = behind_lenses(field, display);
  const std::set<std::uint16_t> shown(picture.rgb.begin(), picture.rgb.end());
  EXPECT_GT(shown.size(), static_cast<std::size_t>(field.grid.count()) * 3 / 4) << "nearly all views are seen somewhere";
  EXPECT_EQ(picture.rgb, behind_lenses(field, display, 3).rgb) << "for any number of threads";
}

TEST(LensInterlace, screen_plane_looks_the_same_from_everywhere) {
  LightField source;
  source.grid = {1, 1}, source.view_size = {80, 6}, source.aspect = 80.0 / 6.0;
  Image16 colours{80, 6, {}};
  for (int i = 0; i < 480; ++i) colours.rgb.insert(colours.rgb.end(), 3, static_cast<std::uint16_t>(i % 80 < 40 ? 0 : 65535));
  source.stack = colours;
  source.depth = Image(80, 6, 1);
  source.cameras = {1000.0, Vec2d(1.0), Vec2d(40, 3), {{0, 0}}};
  const ThreadPool pool(1);
  DepthViews views = views_from_depth(source, lens_views(sheet_of_ten(), {}), 1.0, pool);
  const Picture picture = interlace_behind_lenses(views.field, sheet_of_ten(), pool);
  const auto& film = std::get<Image>(picture);
  // Interpolation between a view's ten columns blurs the edge at pixel 40.
  for (const int i : {0, 7, 15, 20, 60, 65, 72, 79}) EXPECT_NEAR(film.pixel(i, 2)[0], i < 40 ? 0.0 : 1.0, 1e-3) << i;
}

}  // namespace
}  // namespace lippmann
