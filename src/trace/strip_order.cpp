#include "trace/strip_order.hpp"

#include <algorithm>
#include <cmath>

#include "optics/model.hpp"

namespace lippmann {
namespace {

constexpr int kRowsPerStrip = 16;

void append_down(std::vector<StripPixel>& out, int x0, int x1, int dx, int y0, int y1, int dy) {
  for (int x = x0; x < x1; x += dx)
    for (int y = y0; y < y1; y += dy) out.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
}

void append_rows(std::vector<StripPixel>& out, int width, int height) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
}

void append_view_tiles(std::vector<StripPixel>& out, Vec2i n, int width, int height) {
  constexpr int kTile = 4;
  for (int v = 0; v < n.y; ++v)
    for (int u = 0; u < n.x; ++u)
      for (int y = v; y < height; y += kTile * n.y)
        for (int x = u; x < width; x += kTile * n.x)
          append_down(out, x, std::min(width, x + kTile * n.x), n.x, y, std::min(height, y + kTile * n.y), n.y);
}

void append_lens_groups(std::vector<StripPixel>& out, int n, int width, int height) {
  const int group = n * std::max(1, kPacketsPerBlock / n);
  for (int x0 = 0; x0 < width; x0 += group)
    for (int u = 0; u < n; ++u) append_down(out, x0 + u, std::min(width, x0 + group), n, 0, height, 1);
}

/// Appends groups of 2 x 8 sub-pixels. Rows are shifted along the slant of the lenses, because ray directions differ least
/// along the slant.
void append_along_slant(std::vector<StripPixel>& out, double columns_per_row, int width, int height) {
  constexpr int kColumns = 2, kRows = 8;
  for (int x0 = 0; x0 < width; x0 += kColumns)
    for (int y0 = 0; y0 < height; y0 += kRows)
      for (int x = x0; x < std::min(width, x0 + kColumns); ++x)
        for (int y = y0; y < std::min(height, y0 + kRows); ++y) {
          const long shifted = (x + std::lround(columns_per_row * y)) % width;
          out.push_back({static_cast<std::uint16_t>(shifted < 0 ? shifted + width : shifted), static_cast<std::uint16_t>(y)});
        }
}

int strip_height(const std::optional<LensArray>& lenses, Vec2i n) {
  // With four rows of lenses per strip, a packet can cover 4 x 4 pixels of one view.
  if (lenses && lenses->row_pitch_mm > 0.0 && n.y > 0) return 4 * n.y;
  return kRowsPerStrip;
}

}  // namespace

int rows_per_strip(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  return std::min(strip_height(facts.lenses, facts.whole_pixels_per_lens), film_size(optics).y);
}

StripOrder make_strip_order(const Optics& optics, RayOrder order) {
  const OpticsFacts facts = optics_facts(optics);
  const Vec2i n = facts.whole_pixels_per_lens;
  const int width = film_size(optics).x;
  StripOrder strip;
  strip.strip_height = rows_per_strip(optics);
  strip.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(strip.strip_height));
  const bool one_dimensional = facts.lenses && !(facts.lenses->row_pitch_mm > 0.0);
  switch (order) {
    case RayOrder::kRows:
      append_rows(strip.pixels, width, strip.strip_height);
      break;
    case RayOrder::kColumns:
      append_down(strip.pixels, 0, width, 1, 0, strip.strip_height, 1);
      break;
    case RayOrder::kViewTiles:
      if (facts.lens_columns_per_row) {
        append_along_slant(strip.pixels, *facts.lens_columns_per_row, width, strip.strip_height);
      } else if (one_dimensional && n.x > 0) {
        append_lens_groups(strip.pixels, n.x, width, strip.strip_height);
      } else if (one_dimensional) {
        append_down(strip.pixels, 0, width, 1, 0, strip.strip_height, 1);
      } else {
        append_view_tiles(strip.pixels, n.x > 0 ? n : Vec2i(1, 1), width, strip.strip_height);
      }
      break;
  }
  return strip;
}

}  // namespace lippmann
