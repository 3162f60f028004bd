#include "bench/light_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/random.hpp"

namespace lippmann::bench {
namespace {

const MultiView* views_of(const Optics& optics) { return std::get_if<MultiView>(&optics.model); }

/// Rows of a strip of the panel, from `top` on.
void append_drawn_rows(int top, int height, int share, std::vector<int>& rows) {
  for (int k = 0; k * share < height; ++k) {
    const int row = k * share + static_cast<int>(hash(static_cast<std::uint32_t>(k)) % static_cast<std::uint32_t>(share));
    rows.push_back(top + std::min(row, height - 1));
  }
}

std::vector<ViewTriple> neighbours_below_lenses(int lens_pixels, int width, int rows) {
  std::vector<ViewTriple> triples;
  for (int y = 0; y < rows; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const int view = x % lens_pixels;
      const auto at = static_cast<std::uint32_t>(y * width + x);
      if (view > 0 && view + 1 < lens_pixels) triples.push_back({at - 1, at, at + 1});
    }
  return triples;
}

/// Tiles hold the same rows each; view v lies at column v mod columns, row v / columns from the bottom.
std::vector<ViewTriple> neighbours_among_tiles(const MultiView& views, int width, int rows) {
  const int tile_width = width / views.columns, tile_rows = rows / views.rows;
  const auto pixel_of = [&](int view, int x, int y) {
    const int row = (views.rows - 1 - view / views.columns) * tile_rows + y;
    return static_cast<std::uint32_t>(row * width + view % views.columns * tile_width + x);
  };
  std::vector<ViewTriple> triples;
  for (int v = 1; v + 1 < views.columns * views.rows; ++v) {
    const bool in_one_row = v % views.columns > 0 && (v + 1) % views.columns > 0;
    if (views.baseline_mm > 0.0f && !in_one_row) continue;
    for (int y = 0; y < tile_rows; ++y)
      for (int x = 0; x < tile_width; ++x) triples.push_back({pixel_of(v - 1, x, y), pixel_of(v, x, y), pixel_of(v + 1, x, y)});
  }
  return triples;
}

int second_difference(int a, int b, int c) { return std::abs(a - 2 * b + c); }

}  // namespace

std::vector<int> rows_to_compare(const Optics& optics, int share) {
  std::vector<int> rows;
  const MultiView* views = views_of(optics);
  const int bands = views ? views->rows : 1, height = optics.panel.height / bands;
  const int padding = optics.panel.height - bands * height;
  for (int band = 0; band < bands; ++band) append_drawn_rows(padding + band * height, height, share, rows);
  return rows;
}

Image8 take_rows(const Image8& picture, const std::vector<int>& rows) {
  Image8 taken{picture.width, static_cast<int>(rows.size()), {}};
  const std::ptrdiff_t stride = 3 * static_cast<std::ptrdiff_t>(picture.width);
  for (const int row : rows)
    taken.rgb.insert(taken.rgb.end(), picture.rgb.begin() + row * stride, picture.rgb.begin() + (row + 1) * stride);
  return taken;
}

std::vector<ViewTriple> neighbouring_views(const Optics& optics, const std::vector<int>& rows) {
  const int count = static_cast<int>(rows.size());
  if (const MultiView* views = views_of(optics)) return neighbours_among_tiles(*views, optics.panel.width, count);
  const int lens_pixels = whole_pixels_per_lens(optics).x;
  return lens_pixels > 2 ? neighbours_below_lenses(lens_pixels, optics.panel.width, count) : std::vector<ViewTriple>{};
}

double mean_squared_error(const Frames& reference, const Frames& test) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < reference.size(); ++f) {
    for (std::size_t i = 0; i < reference[f].rgb.size(); ++i) {
      const double difference = reference[f].rgb[i] - test[f].rgb[i];
      sum += difference * difference;
    }
    count += reference[f].rgb.size();
  }
  return sum / static_cast<double>(count);
}

double view_flicker(const Frames& frames, const std::vector<ViewTriple>& views) {
  double sum = 0.0;
  for (const Image8& frame : frames)
    for (const ViewTriple& v : views)
      for (std::size_t c = 0; c < 3; ++c)
        sum += second_difference(frame.rgb[3 * v[0] + c], frame.rgb[3 * v[1] + c], frame.rgb[3 * v[2] + c]);
  return sum / static_cast<double>(3 * frames.size() * views.size());
}

double frame_flicker(const Frames& frames) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 1; f + 1 < frames.size(); ++f) {
    for (std::size_t i = 0; i < frames[f].rgb.size(); ++i)
      sum += second_difference(frames[f - 1].rgb[i], frames[f].rgb[i], frames[f + 1].rgb[i]);
    count += frames[f].rgb.size();
  }
  return sum / static_cast<double>(count);
}

double psnr_at_time(std::vector<TimedQuality> measured, double seconds) {
  std::sort(measured.begin(), measured.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  if (seconds <= measured.front().seconds) return measured.front().psnr_db;
  for (std::size_t i = 1; i < measured.size(); ++i) {
    const TimedQuality &before = measured[i - 1], &after = measured[i];
    if (seconds > after.seconds) continue;
    const double share = std::log(seconds / before.seconds) / std::log(after.seconds / before.seconds);
    return before.psnr_db + share * (after.psnr_db - before.psnr_db);
  }
  return measured.back().psnr_db;
}

}  // namespace lippmann::bench
