// Based on: E. Hecht, Optics, 5th edition (2017), section 5.2.2, "Refraction at Spherical Surfaces". A surface of radius r
// between air and a medium of index n focuses distant paraxial light at depth f = n r / (n - 1). The print at depth t is sharp
// if f = t, so r = t (n - 1) / n.
//
// The viewing angle is 2 b. The outermost ray runs from the edge of the strip, p / 2 from the axis at depth t, to the vertex of
// the lens. Inside the lens, its angle a to the axis is tan a = p / (2 t). Outside, its angle b is sin b = n sin a (Snell).
#include "sheet/lens_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/limits.hpp"
#include "layout/strip_place.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Height of the lens surface at distance x_mm from the axis of the lens; 0 at the edges of the lens.
double cap_mm(const LensShape& shape, double x_mm) {
  const double r = shape.radius_mm, half = 0.5 * shape.pitch_mm;
  return std::sqrt(std::max(0.0, r * r - x_mm * x_mm)) - std::sqrt(std::max(0.0, r * r - half * half));
}

double viewing_angle_deg(const LensShape& shape, double index) {
  const double inside = std::atan(0.5 * shape.pitch_mm / shape.thickness_mm);
  return 2.0 * std::asin(std::min(1.0, index * std::sin(inside))) * 180.0 / std::numbers::pi;
}

double radius_of(double pitch_mm, const LensSpec& spec) {
  const double half = 0.5 * pitch_mm, n = spec.refractive_index;
  const int given = spec.radius_mm.has_value() + spec.height_mm.has_value() + spec.thickness_mm.has_value();
  if (given != 1)
    throw usage_error(
        "thickness-mm",
        given == 0 ? "is missing: the shape of the lenses is unknown" : "conflicts with the other values for the shape",
        "one of `thickness-mm`, `radius-mm` and `height-mm`");
  const auto refuse = [&](const char* name, double value, const std::string& accepted) {
    return usage_error(
        name, fmt::format("with {:g} mm, lenses of the width {:.4f} mm would be more than half a cylinder", value, pitch_mm),
        accepted);
  };
  if (spec.height_mm) {
    const double s = *spec.height_mm;
    if (s > half) throw refuse("height-mm", s, fmt::format("at most {:.4f}", half));
    return (half * half + s * s) / (2.0 * s);
  }
  if (spec.radius_mm) {
    if (*spec.radius_mm < half) throw refuse("radius-mm", *spec.radius_mm, fmt::format("at least {:.4f}", half));
    return *spec.radius_mm;
  }
  const double radius = *spec.thickness_mm * (n - 1.0) / n;
  if (radius < half)
    throw refuse("thickness-mm", *spec.thickness_mm,
                 fmt::format("at least {:.4f} for the index {:g}", half * n / (n - 1.0), n));
  return radius;
}

}  // namespace

LensShape lens_shape(double pitch_mm, const LensSpec& spec) {
  const double n = spec.refractive_index;
  LensShape shape;
  shape.pitch_mm = pitch_mm;
  shape.radius_mm = radius_of(pitch_mm, spec);
  shape.height_mm = cap_mm(shape, 0.0);
  shape.thickness_mm = n * shape.radius_mm / (n - 1.0);
  shape.view_angle_deg = viewing_angle_deg(shape, n);
  return shape;
}

HeightMap lens_heights(const Display& sheet, const LensShape& shape, const ThreadPool& pool) {
  const Vec2i size = sheet.pixels;
  check_image_size("paper", size.x, size.y, 1);
  const LensStrips strips = lens_strips(sheet);
  // The printed strips are wider than the lenses above them. Lenses and strips are aligned at the centre of the print. Scaling
  // a position on the lenses about the centre by `stretch` gives the corresponding position on the strips.
  const double stretch = strips.cell_px / (shape.pitch_mm / sheet.pixel_mm());
  const Vec2d centre = 0.5 * Vec2d(size);
  const auto code_at = [&](int x, int y) {
    const double within = strip_place(strips, centre + stretch * (Vec2d(x + 0.5, y + 0.5) - centre)).within;
    const double share = cap_mm(shape, (within - 0.5) * shape.pitch_mm) / shape.height_mm;
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(share, 0.0, 1.0)));
  };
  HeightMap map{size.x, size.y};
  const auto width = static_cast<std::size_t>(size.x);
  map.codes.resize(width * static_cast<std::size_t>(size.y));
  const auto fill_row = [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) map.codes[y * width + x] = code_at(static_cast<int>(x), static_cast<int>(y));
  };
  fill_row(0);
  pool.for_each(static_cast<std::size_t>(size.y), [&](std::size_t y) {
    if (y == 0) return;
    if (strips.sine != 0.0) return fill_row(y);
    const auto row = map.codes.begin() + static_cast<std::ptrdiff_t>(y * width);
    std::copy_n(map.codes.begin(), width, row);
  });
  return map;
}

}  // namespace lippmann
