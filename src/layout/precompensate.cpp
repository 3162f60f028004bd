// Solves A v' = v: the display shows v', the crosstalk matrix A mixes its samples, and an eye sees v (precompensate.hpp).
//
// Each row of A has the sum 1: it holds crosstalk weights, divided by the sum of the weights that lie inside the line of
// samples. Multiplying every row by its sum of weights gives an equation whose matrix is symmetric and positive definite.
// Samples are limited to what the display can show, so this is a linear complementarity problem. It is solved by projected
// Gauss-Seidel: Cryer, "The solution of a quadratic programming problem using systematic overrelaxation", SIAM J. Control 9,
// 1971.
//
// Microlenses and camera grids have crosstalk along two axes: A = Ax Ay. Ay is inverted first, without limits, then Ax with
// limits.
#include "lippmann/layout/precompensate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/multiversion.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

constexpr double kExact = 1e-7;  ///< accuracy of the solution in linear light; far below a 16-bit step
constexpr int kMaxSweeps = 2000;

/// Parallel lines of samples in a picture. Their first samples are arranged in `rows` rows of `across` neighbouring samples.
/// `sample`: offsets of a line's samples from its first sample. `row_stride`: distance from a row of first samples to the next
/// row. All offsets and distances are differences of indices into the picture's array of floats.
struct Lines {
  std::vector<std::size_t> sample;
  std::size_t across = 0, rows = 0, row_stride = 0;
};

struct Bounds {
  double low, high;
};
constexpr Bounds kLight{0.0, 1.0}, kNoBounds{-INFINITY, INFINITY};

/// kLanes lines are processed together. A Lane holds one sample of each of these lines.
constexpr std::size_t kLanes = 8;
using Lane = std::array<double, kLanes>;

/// Crosstalk along lines of one length. weights[k]: weight of the samples at distance k. sums[i]: sum of the weights
/// around sample i that lie inside the line.
struct Leak {
  std::vector<double> weights, sums;

  Leak(std::size_t length, double sigma_px) : sums(length) {
    for (const Tap& tap : gaussian_taps(0.5, sigma_px))
      if (tap.index >= 0) weights.push_back(tap.weight);
    for (std::size_t i = 0; i < length; ++i) {
      for (std::size_t j = 1; j < weights.size(); ++j) sums[i] += ((i >= j) + (i + j < length)) * weights[j];
      sums[i] += weights[0];
    }
  }
};

LIPPMANN_INLINE void add_neighbours(const Leak& leak, const Lane* samples, std::size_t i, Lane& sum) {
  const std::size_t length = leak.sums.size();
  for (std::size_t j = 1; j < leak.weights.size(); ++j) {
    const double weight = leak.weights[j];
    if (i >= j)
      for (std::size_t l = 0; l < kLanes; ++l) sum[l] += weight * samples[i - j][l];
    if (i + j < length)
      for (std::size_t l = 0; l < kLanes; ++l) sum[l] += weight * samples[i + j][l];
  }
}

LIPPMANN_MULTIVERSION void leak_lines(const Leak& leak, const Lane* shown, Lane* seen) {
  for (std::size_t i = 0; i < leak.sums.size(); ++i) {
    Lane sum{};
    add_neighbours(leak, shown, i, sum);
    for (std::size_t l = 0; l < kLanes; ++l) seen[i][l] = (leak.weights[0] * shown[i][l] + sum[l]) / leak.sums[i];
  }
}

/// For each lane: largest change in one sweep, and number of clipped samples.
struct Swept {
  Lane change{}, clipped{};
};

LIPPMANN_MULTIVERSION void sweep(const Leak& leak, const Lane* wanted, Bounds bounds, Lane* shown, Swept& swept) {
  const double inverse = 1.0 / leak.weights[0];
  for (std::size_t i = 0; i < leak.sums.size(); ++i) {
    Lane sum{};
    add_neighbours(leak, shown, i, sum);
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double free = (leak.sums[i] * wanted[i][l] - sum[l]) * inverse;
      double value = free < bounds.low ? bounds.low : free;
      value = value > bounds.high ? bounds.high : value;
      const double change = std::abs(value - shown[i][l]);
      swept.clipped[l] += std::abs(value - free) > 1e3 * kExact ? 1.0 : 0.0;
      swept.change[l] = change > swept.change[l] ? change : swept.change[l];
      shown[i][l] = value;
    }
  }
}

/// Computes the samples that kLanes lines must show, and returns how many of them are clipped to `bounds`.
std::size_t solve_lines(const Leak& leak, const std::vector<Lane>& wanted, Bounds bounds, std::vector<Lane>& shown) {
  shown = wanted;
  Swept swept;
  for (int count = 0; count < kMaxSweeps; ++count) {
    swept = {};
    sweep(leak, wanted.data(), bounds, shown.data(), swept);
    if (*std::max_element(swept.change.begin(), swept.change.end()) <= kExact) break;
  }
  return static_cast<std::size_t>(std::accumulate(swept.clipped.begin(), swept.clipped.end(), 0.0));
}

/// Calls change(leak, samples) for all lines, kLanes lines at a time. If fewer lines are left, the remaining lanes are 0.
template <class Change>
void for_each_line(const std::vector<Lines>& all, double sigma_px, Image& picture, Change change) {
  for (const Lines& lines : all) {
    const Leak leak(lines.sample.size(), sigma_px);
    std::vector<Lane> samples(lines.sample.size());
    const std::size_t count = lines.rows * lines.across;
    for (std::size_t first = 0; first < count; first += kLanes) {
      const std::size_t lanes = std::min(kLanes, count - first);
      std::array<float*, kLanes> start{};
      for (std::size_t l = 0; l < lanes; ++l)
        start[l] = picture.data.data() + (first + l) / lines.across * lines.row_stride + (first + l) % lines.across;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = {};
        for (std::size_t l = 0; l < lanes; ++l) samples[i][l] = start[l][lines.sample[i]];
      }
      change(leak, samples);
      for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t l = 0; l < lanes; ++l) start[l][lines.sample[i]] = static_cast<float>(samples[i][l]);
    }
  }
}

struct LinesOfAxes {
  std::vector<Lines> across, up;
};

std::vector<std::size_t> counted(std::size_t count, std::size_t step) {
  std::vector<std::size_t> offsets(count);
  for (std::size_t i = 0; i < count; ++i) offsets[i] = i * step;
  return offsets;
}

LinesOfAxes lines_of_panel(const Image& picture) {
  const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
  return {{{counted(width, 3), 3, height, 3 * width}}, {{counted(height, 3 * width), 3 * width, 1, 0}}};
}

LinesOfAxes lines_of_views(const Image& picture, const ViewTiles& views) {
  const auto columns = static_cast<std::size_t>(views.columns), rows = static_cast<std::size_t>(views.rows);
  const std::size_t row_stride = 3 * static_cast<std::size_t>(picture.width);
  const std::size_t width = static_cast<std::size_t>(picture.width) / columns;
  const std::size_t height = static_cast<std::size_t>(picture.height) / rows;
  const auto tile = [&](std::size_t column, std::size_t row_from_below) {
    return (static_cast<std::size_t>(picture.height) - (row_from_below + 1) * height) * row_stride + 3 * column * width;
  };
  Lines lines{{}, 3 * width, height, row_stride};
  LinesOfAxes all;
  const bool grid = views.camera_grid;
  for (std::size_t row = 0; row < rows; ++row) {
    if (grid || row == 0) lines.sample.clear();
    for (std::size_t column = 0; column < columns; ++column) lines.sample.push_back(tile(column, row));
    if (grid || row + 1 == rows) all.across.push_back(lines);
  }
  for (std::size_t column = 0; grid && column < columns; ++column) {
    lines.sample.clear();
    for (std::size_t row = 0; row < rows; ++row) lines.sample.push_back(tile(column, row));
    all.up.push_back(lines);
  }
  return all;
}

/// Applies the crosstalk to a picture, so that it becomes what an eye sees.
void leak_light(const LinesOfAxes& lines, Vec2d sigma, Image& picture) {
  const auto leak_line = [seen = std::vector<Lane>()](const Leak& leak, std::vector<Lane>& samples) mutable {
    seen.resize(samples.size());
    leak_lines(leak, samples.data(), seen.data());
    samples.swap(seen);
  };
  if (sigma.x > 0.0) for_each_line(lines.across, sigma.x, picture, leak_line);
  if (sigma.y > 0.0) for_each_line(lines.up, sigma.y, picture, leak_line);
}

double largest_difference(const Image& a, const Image& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(a.data[i]) - static_cast<double>(b.data[i])));
  return largest;
}

}  // namespace

Precompensation precompensate(const Optics& optics, double sigma_px, const char* where, Image& picture) {
  if (crosstalk_sigmas(optics, 1.0) == Vec2d(0.0))
    throw usage_error(where, "a single view has no neighbours", "optics with several views");
  const Vec2d sigma = crosstalk_sigmas(optics, sigma_px);
  if (!(std::max(sigma.x, sigma.y) <= kMaxPrecompensatedPx))
    throw usage_error(where,
                      fmt::format("crosstalk with a sigma of {:.3g} pixels (views) is too strong to be "
                                  "compensated",
                                  std::max(sigma.x, sigma.y)),
                      fmt::format("at most {} pixels or views; use fewer views or no precompensation", kMaxPrecompensatedPx));
  for (float& value : picture.data) value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN becomes 0
  const std::optional<ViewTiles> views = view_tiles(optics);
  const LinesOfAxes lines = views ? lines_of_views(picture, *views) : lines_of_panel(picture);
  const Image wanted = picture;
  std::size_t clipped = 0;
  std::vector<Lane> shown;
  const auto solve = [&](Bounds bounds) {
    return [&, bounds](const Leak& leak, std::vector<Lane>& samples) {
      clipped += solve_lines(leak, samples, bounds, shown);
      samples.swap(shown);
    };
  };
  if (sigma.y > 0.0) for_each_line(lines.up, sigma.y, picture, solve(kNoBounds));
  if (sigma.x > 0.0) for_each_line(lines.across, sigma.x, picture, solve(kLight));
  Image seen = picture;
  leak_light(lines, sigma, seen);
  const double samples = static_cast<double>(std::max<std::size_t>(1, picture.data.size()));
  return {static_cast<double>(clipped) / samples, largest_difference(seen, wanted)};
}

Precompensation precompensate_encoded(const Optics& optics, double sigma_px, Encoding encoding, const char* where,
                                      Image& film) {
  if (encoding == Encoding::kSrgb) return precompensate(optics, sigma_px, where, film);
  // The correction needs linear values, because crosstalk mixes linear light.
  for (float& value : film.data) value = static_cast<float>(linear_from_srgb(value > 0.0f ? std::min(value, 1.0f) : 0.0f));
  const Precompensation done = precompensate(optics, sigma_px, where, film);
  for (float& value : film.data) value = static_cast<float>(srgb_from_linear(value));
  return done;
}

}  // namespace lippmann
