#include "bench/light_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/random.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::bench {
namespace {

/// Rows of a strip of the panel, from `top` on: a band in each of its stretches.
void append_drawn_rows(int top, int height, int band, int share, std::vector<int>& rows) {
  const int stretch = band * share;
  for (int k = 0; k * stretch < height; ++k) {
    const int length = std::min(stretch, height - k * stretch), places = std::max(1, length - band + 1);
    const int offset = static_cast<int>(hash(static_cast<std::uint32_t>(k)) % static_cast<std::uint32_t>(places));
    for (int y = 0; y < std::min(band, length); ++y) rows.push_back(top + k * stretch + offset + y);
  }
}

/// From a pixel to the next one of the same view; none where pixels have no whole lenses.
std::optional<Vec2i> step_within_view(const Optics& optics) {
  const Vec2i step = whole_pixels_per_lens(optics);
  if (step.x < 1 || step.y < 1) return std::nullopt;
  return step;
}

/// Views side by side whose pixels are `step` apart; `x` and `y` are the first view's upper left pixel.
struct ViewArea {
  int x = 0, y = 0, width = 0, height = 0;
  Vec2i step{1};
};

/// The areas of the picture of compared rows: its tiles, or all of it.
std::vector<ViewArea> view_areas(const Optics& optics, int rows) {
  const auto step = step_within_view(optics);
  if (!step) return {};
  const std::optional<ViewTiles> views = view_tiles(optics);
  const Vec2i tiles = views ? Vec2i(views->columns, views->rows) : Vec2i(1);
  const int width = optics.panel.width / tiles.x, height = rows / tiles.y;
  std::vector<ViewArea> areas;
  for (int row = 0; row < tiles.y; ++row)
    for (int column = 0; column < tiles.x; ++column) areas.push_back({column * width, row * height, width, height, *step});
  return areas;
}

Block block_at(Vec2i corner, Vec2i step, int picture_width) {
  Block block;
  for (int y = 0; y < kBlockSide; ++y)
    for (int x = 0; x < kBlockSide; ++x)
      block[static_cast<std::size_t>(y * kBlockSide + x)] =
          static_cast<std::uint32_t>((corner.y + y * step.y) * picture_width + corner.x + x * step.x);
  return block;
}

/// The blocks of a band of rows of an area: of each of its views one beside the other.
void append_blocks(const ViewArea& area, int top, int picture_width, std::vector<Block>& blocks) {
  const Vec2i size = kBlockSide * area.step;
  for (int left = 0; left + size.x <= area.width; left += size.x)
    for (int v = 0; v < area.step.y; ++v)
      for (int u = 0; u < area.step.x; ++u)
        blocks.push_back(block_at({area.x + left + u, area.y + top + v}, area.step, picture_width));
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
std::vector<ViewTriple> neighbours_among_tiles(const ViewTiles& views, int width, int rows) {
  const int tile_width = width / views.columns, tile_rows = rows / views.rows;
  const auto pixel_of = [&](int view, int x, int y) {
    const int row = (views.rows - 1 - view / views.columns) * tile_rows + y;
    return static_cast<std::uint32_t>(row * width + view % views.columns * tile_width + x);
  };
  std::vector<ViewTriple> triples;
  for (int v = 1; v + 1 < views.columns * views.rows; ++v) {
    const bool in_one_row = v % views.columns > 0 && (v + 1) % views.columns > 0;
    if (views.camera_grid && !in_one_row) continue;
    for (int y = 0; y < tile_rows; ++y)
      for (int x = 0; x < tile_width; ++x) triples.push_back({pixel_of(v - 1, x, y), pixel_of(v, x, y), pixel_of(v + 1, x, y)});
  }
  return triples;
}

int second_difference(int a, int b, int c) { return std::abs(a - 2 * b + c); }

bool differs(const Image8& picture, std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t c = 0; c < 3; ++c)
    if (std::abs(picture.rgb[3 * a + c] - picture.rgb[3 * b + c]) >= kEdgeCodes) return true;
  return false;
}

/// Whether the block's pixel `i` is another than one beside, above or below it in the block.
bool is_at_edge(const Image8& picture, const Block& block, std::size_t i) {
  const std::size_t side = kBlockSide, x = i % side, y = i / side;
  return (x > 0 && differs(picture, block[i], block[i - 1])) || (x + 1 < side && differs(picture, block[i], block[i + 1])) ||
         (y > 0 && differs(picture, block[i], block[i - side])) ||
         (y + 1 < side && differs(picture, block[i], block[i + side]));
}

}  // namespace

std::vector<int> rows_to_compare(const Optics& optics, int share) {
  std::vector<int> rows;
  const std::optional<ViewTiles> views = view_tiles(optics);
  const int bands = views ? views->rows : 1, height = optics.panel.height / bands;
  const int padding = optics.panel.height - bands * height;
  const auto step = step_within_view(optics);
  const int block_rows = kBlockSide * (step ? step->y : 1);
  for (int band = 0; band < bands; ++band) append_drawn_rows(padding + band * height, height, block_rows, share, rows);
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
  if (const std::optional<ViewTiles> views = view_tiles(optics))
    return neighbours_among_tiles(*views, optics.panel.width, count);
  const int lens_pixels = whole_pixels_per_lens(optics).x;
  return lens_pixels > 2 ? neighbours_below_lenses(lens_pixels, optics.panel.width, count) : std::vector<ViewTriple>{};
}

std::vector<Block> view_blocks(const Optics& optics, const std::vector<int>& rows) {
  std::vector<Block> blocks;
  for (const ViewArea& area : view_areas(optics, static_cast<int>(rows.size()))) {
    const int high = kBlockSide * area.step.y;
    const auto row_at = [&](int y) { return rows[static_cast<std::size_t>(area.y + y)]; };
    for (int top = 0; top + high <= area.height; top += high)
      if (row_at(top + high - 1) == row_at(top) + high - 1) append_blocks(area, top, optics.panel.width, blocks);
  }
  return blocks;
}

std::vector<double> block_means(const Image8& picture, const std::vector<Block>& blocks) {
  std::vector<double> means;
  means.reserve(3 * blocks.size());
  for (const Block& block : blocks)
    for (std::size_t c = 0; c < 3; ++c) {
      int sum = 0;
      for (const std::uint32_t pixel : block) sum += picture.rgb[3 * pixel + c];
      means.push_back(sum / static_cast<double>(block.size()));
    }
  return means;
}

Image8 mean_of(const Reference& reference) {
  Image8 mean = reference[0];
  for (std::size_t i = 0; i < mean.rgb.size(); ++i)
    mean.rgb[i] = static_cast<unsigned char>((reference[0].rgb[i] + reference[1].rgb[i]) / 2);
  return mean;
}

double mean_squared_error(const References& references, const Frames& test) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < references.size(); ++f) {
    const auto& [first, second] = references[f];
    for (std::size_t i = 0; i < first.rgb.size(); ++i)
      sum += (test[f].rgb[i] - first.rgb[i]) * (test[f].rgb[i] - second.rgb[i]);
    count += first.rgb.size();
  }
  return std::max(0.0, sum / static_cast<double>(count));
}

double block_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks) {
  if (blocks.empty()) return std::nan("");
  double sum = 0.0;
  for (std::size_t f = 0; f < references.size(); ++f) {
    const std::vector<double> first = block_means(references[f][0], blocks), second = block_means(references[f][1], blocks),
                              made = block_means(test[f], blocks);
    for (std::size_t i = 0; i < made.size(); ++i) sum += (made[i] - first[i]) * (made[i] - second[i]);
  }
  return std::max(0.0, sum / static_cast<double>(3 * blocks.size() * references.size()));
}

double worst_block_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks) {
  struct BlockError {
    double seen = 0.0, squared = 0.0;  ///< against the mean of both references, and against one times the other
  };
  std::vector<BlockError> errors(blocks.size() * references.size());
  if (errors.empty()) return std::nan("");
  for (std::size_t f = 0; f < references.size(); ++f) {
    const std::vector<double> first = block_means(references[f][0], blocks), second = block_means(references[f][1], blocks),
                              made = block_means(test[f], blocks);
    for (std::size_t i = 0; i < made.size(); ++i) {
      BlockError& error = errors[f * blocks.size() + i / 3];
      const double a = made[i] - first[i], b = made[i] - second[i];
      error.seen += 0.25 * (a + b) * (a + b), error.squared += a * b;
    }
  }
  const auto worst = static_cast<std::ptrdiff_t>(std::max<std::size_t>(errors.size() / 100, 1));
  std::partial_sort(errors.begin(), errors.begin() + worst, errors.end(),
                    [](const BlockError& a, const BlockError& b) { return a.seen > b.seen; });
  double sum = 0.0;
  for (auto e = errors.begin(); e != errors.begin() + worst; ++e) sum += e->squared;
  return std::max(0.0, sum / static_cast<double>(3 * worst));
}

double edge_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < references.size(); ++f) {
    const Image8 mean = mean_of(references[f]);
    for (const Block& block : blocks)
      for (std::size_t i = 0; i < block.size(); ++i) {
        if (!is_at_edge(mean, block, i)) continue;
        for (std::size_t v = 3 * block[i]; v < 3 * block[i] + 3; ++v)
          sum += (test[f].rgb[v] - references[f][0].rgb[v]) * (test[f].rgb[v] - references[f][1].rgb[v]);
        count += 3;
      }
  }
  return count > 0 ? std::max(0.0, sum / static_cast<double>(count)) : std::nan("");
}

double mean_light_ratio(const References& references, const Frames& test) {
  std::array<double, 256> light;
  for (std::size_t code = 0; code < light.size(); ++code) light[code] = linear_from_srgb(static_cast<double>(code) / 255.0);
  const auto light_of = [&](const Image8& frame) {
    double sum = 0.0;
    for (const unsigned char code : frame.rgb) sum += light[code];
    return sum;
  };
  double truth = 0.0, made = 0.0;
  for (const auto& [first, second] : references) truth += 0.5 * (light_of(first) + light_of(second));
  for (const Image8& frame : test) made += light_of(frame);
  return made / truth;
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

EstimateFigures judge_estimates(const std::vector<std::optional<double>>& estimates_db, const std::vector<double>& true_db) {
  double sum = 0.0, excess = 0.0;
  EstimateFigures figures;
  for (std::size_t f = 0; f < estimates_db.size(); ++f) {
    if (!estimates_db[f] || !std::isfinite(true_db[f])) continue;
    const double error = *estimates_db[f] - true_db[f];
    sum += *estimates_db[f], excess += error, ++figures.frames;
    if (std::abs(error) <= kCloseDb) ++figures.close;
    figures.largest_error_db = std::max(figures.largest_error_db, std::abs(error));
  }
  figures.mean_db = sum / figures.frames, figures.mean_excess_db = excess / figures.frames;  // not numbers without frames
  if (figures.frames == 0) figures.largest_error_db = std::nan("");
  return figures;
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
