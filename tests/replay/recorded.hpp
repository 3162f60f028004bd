// Records panels without a renderer: a pixel takes the known colour where its ray meets a plane.
#pragma once

#include <cmath>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann::test {

inline Vec3f waves(Vec2d p) {
  return {0.5 + 0.4 * std::sin(0.9 * p.x + 0.3 * p.y), 0.5 + 0.4 * std::cos(0.7 * p.y), 0.5 + 0.3 * std::sin(0.5 * p.x - p.y)};
}

inline Vec2d meets(const Optics& optics, int x, int y, double z) {
  const Ray ray = ray_of_pixel(optics, Vec2f(x, y) + 0.5f);
  return Vec2d(ray.origin) + Vec2d(ray.direction) * ((z - ray.origin.z) / ray.direction.z);
}

template <class Color>
RenderedPanel record(const Optics& optics, double z, const Color& color) {
  RenderedPanel panel{optics, Image(film_size(optics).x, film_size(optics).y, 3)};
  for (int y = 0; y < panel.picture.height; ++y)
    for (int x = 0; x < panel.picture.width; ++x) {
      const Vec3f c = color(meets(optics, x, y, z));
      std::copy_n(&c.x, 3, panel.picture.pixel(x, y));
    }
  return panel;
}

inline RenderedPanel record_point(const Optics& optics, Vec3f point_mm) {
  RenderedPanel panel{optics, Image(optics.panel.width, optics.panel.height, 3)};
  std::vector<Vec2f> pixels;
  pixels_seeing(optics, point_mm, pixels);
  for (const Vec2f pixel : pixels) std::fill_n(panel.picture.pixel(int(pixel.x), int(pixel.y)), 3, 1.0f);
  return panel;
}

/// Returns the plane at depth z as an eye sees it through the display's window, without lenses.
template <class Color>
Image seen_directly(const Optics& optics, Vec2i size, Vec3d eye_mm, double z, const Color& color) {
  const Window window = display_window(optics);
  Image picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Vec2d s = window.point_at({x + 0.5, y + 0.5}, size);
      const Vec3f c = color(s + (Vec2d(eye_mm) - s) * (z / eye_mm.z));
      std::copy_n(&c.x, 3, picture.pixel(x, y));
    }
  return picture;
}

/// Returns the PSNR in dB of linear values with the peak 1, without `border` pixels at the edges.
inline double linear_psnr(const Image& a, const Image& b, int border = 0) {
  double sum = 0.0;
  std::size_t count = 0;
  for (int y = border; y < a.height - border; ++y)
    for (int x = border; x < a.width - border; ++x)
      for (int c = 0; c < 3; ++c, ++count) sum += std::pow(a.pixel(x, y)[c] - b.pixel(x, y)[c], 2.0);
  return -10.0 * std::log10(std::max(sum / static_cast<double>(count), 1e-30));
}

inline Optics sheet(float viewing_distance_mm = kInfinity, float slant = 0.0f) {
  Optics optics;
  const float gap = 2.0f, spread = 1.0f + gap / viewing_distance_mm;
  optics.panel = {360, 120, 1.0f / 9};
  LenticularSheet sheet;
  sheet.lens_pitch_mm = std::cos(slant) / spread;
  sheet.gap_mm = gap;
  sheet.offset_mm = 0.5f * sheet.lens_pitch_mm;
  sheet.slant = slant;
  sheet.viewing_distance_mm = viewing_distance_mm;
  optics.model = sheet;
  return optics;
}

inline Optics lenslets(float viewing_distance_mm = kInfinity, LensPacking packing = LensPacking::kSquare) {
  Optics optics;
  const float gap = 2.0f, spread = 1.0f + gap / viewing_distance_mm;
  optics.panel = {210, 210, 1.0f / 7};
  MicrolensArray array;
  array.packing = packing;
  array.lens_pitch_mm = 1.0f / spread;
  array.gap_mm = gap;
  array.offset_mm = Vec2f(0.5f / spread);
  array.viewing_distance_mm = viewing_distance_mm;
  optics.model = array;
  return optics;
}

inline Optics quilt() {
  Optics optics;
  optics.panel = {180, 120, 0.5f};
  optics.model = MultiView{3, 3, radians(30.0f), false, 100.0f};
  return optics;
}

}  // namespace lippmann::test
