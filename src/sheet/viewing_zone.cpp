#include "sheet/viewing_zone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "image/draw.hpp"
#include "image/limits.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/display_picture.hpp"

namespace lippmann {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns the angle of the centre of a view. The centres are spaced evenly along a line parallel to the sheet.
double middle_angle_deg(const Display& sheet, int view, int views) {
  const double side = 2.0 * (view + 0.5) / views - 1.0;
  return std::atan(side * std::tan(0.5 * sheet.view_cone_deg * kDegree)) / kDegree;
}

/// Returns a colour from red (place 0) over grey (place 1/2) to blue (place 1), light enough for black text.
Rgb8 tint(double place) {
  constexpr std::array<std::array<double, 3>, 3> kTints{{{255, 130, 115}, {235, 235, 235}, {120, 165, 255}}};
  const auto first = static_cast<std::size_t>(place < 0.5 ? 0 : 1);
  Rgb8 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<unsigned char>(
        std::lround(std::lerp(kTints[first][c], kTints[first + 1][c], 2.0 * place - static_cast<double>(first))));
  return colour;
}

/// How often a view repeats its label across and down, and the scale of its text.
struct Tiling {
  Vec2i tiles;
  int scale;
};

Tiling tiling_for(Vec2i size, Vec2i units) {
  Tiling tiling{Vec2i(1), 1};
  for (int across = 3; across >= 1; --across) {
    tiling.scale = size.x / across / (units.x + 4);
    if (tiling.scale < 1) continue;
    const int line = units.y + 6;
    tiling.tiles = {across, std::max(1, size.y / (line * tiling.scale))};
    return tiling;
  }
  tiling.scale = 1;
  return tiling;
}

std::string angle_text(double angle_deg) {
  const long rounded = std::lround(angle_deg);
  return rounded == 0 ? "0 deg" : fmt::format("{:+} deg", rounded);
}

/// Draws one view, which has one column per lens and square pixels.
Picture numbered_view(Vec2i size, int view, int views, double angle_deg) {
  Picture picture = blank(Image8{}, size);
  fill_box(picture, {Vec2i(0), size}, tint(views > 1 ? static_cast<double>(view) / (views - 1) : 0.5));
  const std::string number = fmt::format("{}", view + 1), angle = angle_text(angle_deg);
  const Vec2i number_units(2 * text_units(number).x, 2 * kTextCapital + 4), angle_units = text_units(angle);
  const Tiling tiling = tiling_for(size, {text_units("-00 deg").x, number_units.y + angle_units.y});
  for (int row = 0; row < tiling.tiles.y; ++row)
    for (int column = 0; column < tiling.tiles.x; ++column) {
      const Vec2i middle((2 * column + 1) * size.x / (2 * tiling.tiles.x), (2 * row + 1) * size.y / (2 * tiling.tiles.y));
      const int top = middle.y - tiling.scale * (number_units.y + kTextCapital) / 2;
      draw_text(picture, {middle.x - tiling.scale * number_units.x / 2, top}, 2 * tiling.scale, number);
      draw_text(picture, {middle.x - tiling.scale * angle_units.x / 2, top + tiling.scale * number_units.y}, tiling.scale,
                angle);
    }
  return picture;
}

}  // namespace

int default_zone_views(const Display& sheet) {
  const int most = std::clamp(static_cast<int>(std::lround(0.5 * lens_strips(sheet).cell_px + 1e-6)), 2, 9);
  return most > 2 && most % 2 == 0 ? most - 1 : most;
}

ViewingZoneTest viewing_zone_test(const Display& sheet, int views, const ThreadPool& pool) {
  if (views > views_of(sheet))
    throw usage_error("views", fmt::format("{} views do not fit in {} pixels below a lens", views, views_of(sheet)),
                      fmt::format("2 to {}", views_of(sheet)));
  check_image_size("paper", sheet.pixels.x, sheet.pixels.y, 3);
  ViewFitter fitter(sheet, DisplayTarget::kIntegral, AspectFit::kStretch, pool);
  const double cell = lens_strips(sheet).cell_px;
  const Vec2i size = glm::max(Vec2i(1), Vec2i(glm::round(Vec2d(sheet.pixels) / cell)));
  ViewingZoneTest test;
  LightField field;
  field.grid = {views, 1};
  for (int view = 0; view < views; ++view) {
    test.angles_deg.push_back(middle_angle_deg(sheet, view, views));
    const Picture drawn = numbered_view(size, view, views, test.angles_deg.back());
    const Picture fitted = fitter.fitted(drawn, static_cast<double>(size.x) / size.y);
    if (view == 0) field.view_size = size_of(fitted), field.stack = blank(fitted, stack_size(field));
    set_view(field, view, fitted);
  }
  test.picture = display_picture(field, sheet, DisplayTarget::kIntegral, {}, pool);
  return test;
}

}  // namespace lippmann
