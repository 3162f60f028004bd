// A is symmetric and positive definite up to the sum of weights that stands before what lies at an edge, which goes to the
// other side: (weights - edges) v' = sums v. Within bounds, that is a linear complementarity problem, solved by projected
// Gauss-Seidel: Cryer, "The solution of a quadratic programming problem using systematic overrelaxation", SIAM J. Control 9,
// 1971. Where no bound is met it gives the plain inverse.
//
// Lines of samples that lie next to one another for the lenses are independent. Microlenses and camera grids leak along two
// axes, A = Ax Ay: Ay is inverted first, without bounds, then Ax within them.
#include "layout/precompensate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "optics/crosstalk.hpp"

namespace lippmann {
namespace {

constexpr double kExact = 1e-7;  ///< of linear light: far below a step of 16-bit codes
constexpr int kMaxSweeps = 2000;

/// Samples that are neighbours of one another, as offsets from where a line begins, and where lines begin: at every one of
/// `across` floats of `rows` rows.
struct Lines {
  std::vector<std::size_t> sample;
  std::size_t across = 0, rows = 0, row_stride = 0;
};

struct Bounds {
  double low, high;
};
constexpr Bounds kLight{0.0, 1.0}, kNoBounds{-INFINITY, INFINITY};

/// A along one line.
class Leak {
 public:
  Leak(std::size_t length, double sigma_px) : sums_(length) {
    for (const Tap& tap : gaussian_taps(0.5, sigma_px))
      if (tap.index >= 0) weights_.push_back(tap.weight);
    for (std::size_t i = 0; i < length; ++i) {
      for (std::size_t j = 1; j < weights_.size(); ++j) sums_[i] += ((i >= j) + (i + j < length)) * weights_[j];
      sums_[i] += weights_[0];
    }
  }

  void seen_of(const std::vector<double>& shown, std::vector<double>& seen) const {
    for (std::size_t i = 0; i < sums_.size(); ++i) seen[i] = (weights_[0] * shown[i] + of_neighbours(shown, i)) / sums_[i];
  }

  /// Returns how many of the samples stopped at a bound.
  std::size_t shown_for(const std::vector<double>& wanted, Bounds bounds, std::vector<double>& shown) const {
    shown = wanted;
    std::size_t clipped = 0;
    double change = 1.0;
    for (int sweep = 0; sweep < kMaxSweeps && change > kExact; ++sweep) {
      change = 0.0, clipped = 0;
      for (std::size_t i = 0; i < sums_.size(); ++i) {
        const double free = (sums_[i] * wanted[i] - of_neighbours(shown, i)) / weights_[0];
        const double value = std::clamp(free, bounds.low, bounds.high);
        clipped += std::abs(value - free) > 1e3 * kExact;
        change = std::max(change, std::abs(value - shown[i]));
        shown[i] = value;
      }
    }
    return clipped;
  }

 private:
  double of_neighbours(const std::vector<double>& samples, std::size_t i) const {
    double sum = 0.0;
    for (std::size_t j = 1; j < weights_.size(); ++j) {
      const double before = i >= j ? samples[i - j] : 0.0, after = i + j < samples.size() ? samples[i + j] : 0.0;
      sum += weights_[j] * (before + after);
    }
    return sum;
  }

  std::vector<double> weights_;  ///< of a pixel itself, of its neighbours, of theirs
  std::vector<double> sums_;     ///< of all weights that lie in the line
};

/// change(leak, samples of the line) for every line.
template <class Change>
void for_each_line(const std::vector<Lines>& all, double sigma_px, Image& picture, Change change) {
  for (const Lines& lines : all) {
    const Leak leak(lines.sample.size(), sigma_px);
    std::vector<double> samples(lines.sample.size());
    for (std::size_t row = 0; row < lines.rows; ++row)
      for (std::size_t x = 0; x < lines.across; ++x) {
        float* start = picture.data.data() + row * lines.row_stride + x;
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = start[lines.sample[i]];
        change(leak, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) start[lines.sample[i]] = static_cast<float>(samples[i]);
      }
  }
}

/// Along which lines what the optics show leaks, across and up.
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

/// The same pixel of every view.
LinesOfAxes lines_of_views(const Image& picture, const MultiView& views) {
  const auto columns = static_cast<std::size_t>(views.columns), rows = static_cast<std::size_t>(views.rows);
  const std::size_t row_stride = 3 * static_cast<std::size_t>(picture.width);
  const std::size_t width = static_cast<std::size_t>(picture.width) / columns;
  const std::size_t height = static_cast<std::size_t>(picture.height) / rows;
  const auto tile = [&](std::size_t column, std::size_t row_from_below) {
    return (static_cast<std::size_t>(picture.height) - (row_from_below + 1) * height) * row_stride + 3 * column * width;
  };
  Lines lines{{}, 3 * width, height, row_stride};
  LinesOfAxes all;
  const bool grid = views.baseline_mm > 0.0f;
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

/// What an eye sees of it.
void leak_light(const LinesOfAxes& lines, Vec2d sigma, Image& picture) {
  const auto leak_line = [seen = std::vector<double>()](const Leak& leak, std::vector<double>& samples) mutable {
    seen.resize(samples.size());
    leak.seen_of(samples, seen);
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
  if (std::holds_alternative<SingleView>(optics.model))
    throw usage_error(where, "a single view has no neighbours", "optics of several");
  const Vec2d sigma = crosstalk_sigmas(optics, sigma_px);
  if (!(std::max(sigma.x, sigma.y) <= kMaxPrecompensatedPx))
    throw usage_error(where,
                      fmt::format("neighbours that leak into one another by a sigma of {:.3g} pixels (views) cannot be told "
                                  "apart again",
                                  std::max(sigma.x, sigma.y)),
                      fmt::format("at most {} pixels or views: fewer views, or none of it", kMaxPrecompensatedPx));
  for (float& value : picture.data) value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN: 0
  const auto* views = std::get_if<MultiView>(&optics.model);
  const LinesOfAxes lines = views ? lines_of_views(picture, *views) : lines_of_panel(picture);
  const Image wanted = picture;
  std::size_t clipped = 0;
  std::vector<double> shown;
  const auto solve = [&](Bounds bounds) {
    return [&, bounds](const Leak& leak, std::vector<double>& samples) {
      clipped += leak.shown_for(samples, bounds, shown);
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

}  // namespace lippmann
