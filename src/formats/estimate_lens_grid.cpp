// Estimates the lens grid of a white picture in four steps:
// 1. The two shortest non-parallel vectors to peaks of the autocorrelation are a basis of the lattice. Their angle
// distinguishes square from hexagonal grids. Variations of less than four periods across the picture, such as
// vignetting, are removed first.
// 2. The phase of the picture at the lattice's two fundamental frequencies gives the position of a lens. Light at
// fractions of these frequencies means that the true lattice is coarser; such pictures are refused.
// 3. The centre of each lens is found by mean shift: D. Comaniciu, P. Meer, "Mean shift: a robust approach toward
// feature space analysis", PAMI 2002.
// 4. A grid is fitted to the centres by least squares, first near the middle, then repeatedly over twice the extent.
#include "formats/estimate_lens_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Complex = std::complex<double>;

constexpr int kLargestCrop = 1024, kSmallestCrop = 64;
constexpr double kLeastPitchPx = 4.0;

Error no_lens_grid(const std::string& where, const std::string& problem) {
  return Error(
      where, "cannot find a lens grid: " + problem,
      "a picture of uniform white light through square or hexagonal lenses of 4 pixels or more, or the lens pitch as a "
      "number");
}

/// Computes the Fourier transform in place. The number of values must be a power of two.
void fourier(std::vector<Complex>& values) {
  const std::size_t count = values.size();
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
  for (std::size_t length = 2; length <= count; length *= 2) {
    const double step = -2.0 * std::numbers::pi / static_cast<double>(length);
    for (std::size_t k = 0; k < length / 2; ++k) {
      const Complex turn = std::polar(1.0, step * static_cast<double>(k));
      for (std::size_t i = k; i < count; i += length) {
        const Complex even = values[i], odd = turn * values[i + length / 2];
        values[i] = even + odd, values[i + length / 2] = even - odd;
      }
    }
  }
}

void fourier_2d(std::vector<Complex>& values, std::size_t side) {
  std::vector<Complex> line(side);
  for (std::size_t y = 0; y < side; ++y) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(y * side), side, line.begin());
    fourier(line);
    std::copy_n(line.begin(), side, values.begin() + static_cast<std::ptrdiff_t>(y * side));
  }
  for (std::size_t x = 0; x < side; ++x) {
    for (std::size_t y = 0; y < side; ++y) line[y] = values[y * side + x];
    fourier(line);
    for (std::size_t y = 0; y < side; ++y) values[y * side + x] = line[y];
  }
}

double light_at(const Image& image, int x, int y) {
  return static_cast<double>(*image.pixel(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1)));
}

/// Light at a pixel, filtered to remove the pattern of colour filters.
double smooth_light_at(const Image& image, int x, int y) {
  double sum = 0.0;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) sum += (2 - std::abs(i)) * (2 - std::abs(j)) * light_at(image, x + i, y + j);
  return sum / 16.0;
}

/// Autocorrelation of a square crop from the middle of a picture, for lags up to a quarter of the crop, without
/// variations slower than the lenses.
class Autocorrelation {
 public:
  explicit Autocorrelation(const Image& white) : crop_(std::min({white.width, white.height, kLargestCrop})) {
    while (side_ < crop_) side_ *= 2;
    const auto side = static_cast<std::size_t>(side_);
    std::vector<Complex> values = windowed(white);
    fourier_2d(values, side);
    // Variations with fewer periods across the crop are removed. The largest supported lenses have six periods across the crop.
    constexpr double kSlow = 4.0;
    const double slow = kSlow * side_ / crop_;
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const int u = std::min(x, side_ - x), v = std::min(y, side_ - y);
        values[index(x, y)] = u * u + v * v < slow * slow ? 0.0 : std::norm(values[index(x, y)]);
      }
    fourier_2d(values, side);
    lags_.resize(side * side);
    std::transform(values.begin(), values.end(), lags_.begin(), [](const Complex& value) { return value.real(); });
  }

  int reach() const { return crop_ / 4; }
  double at(int x, int y) const { return lags_[index((x + side_) % side_, (y + side_) % side_)]; }

  bool is_peak(int x, int y) const {
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if ((i != 0 || j != 0) && at(x + i, y + j) >= at(x, y)) return false;
    return true;
  }

  /// Sub-pixel position of a peak at `lag`, from parabolas through the peak and its neighbours.
  Vec2d top(Vec2i lag) const {
    const auto shift = [](double before, double here, double after) {
      return 0.5 * (before - after) / (before - 2.0 * here + after);
    };
    const double here = at(lag.x, lag.y);
    return Vec2d(lag) + Vec2d(shift(at(lag.x - 1, lag.y), here, at(lag.x + 1, lag.y)),
                              shift(at(lag.x, lag.y - 1), here, at(lag.x, lag.y + 1)));
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  double hann(int i) const { return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / crop_); }

  /// The crop's light minus its mean, multiplied by a Hann window and padded with zeros to side_ x side_.
  std::vector<Complex> windowed(const Image& white) const {
    const int left = (white.width - crop_) / 2, top = (white.height - crop_) / 2;
    double light = 0.0, window = 0.0;
    for (int y = 0; y < crop_; ++y)
      for (int x = 0; x < crop_; ++x) {
        const double weight = hann(x) * hann(y);
        light += weight * smooth_light_at(white, left + x, top + y), window += weight;
      }
    std::vector<Complex> values(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (int y = 0; y < crop_; ++y)
      for (int x = 0; x < crop_; ++x)
        values[index(x, y)] = hann(x) * hann(y) * (smooth_light_at(white, left + x, top + y) - light / window);
    return values;
  }

  int crop_, side_ = kSmallestCrop;  // the crop's side, and the next power of two
  std::vector<double> lags_;
};

double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }

/// The two shortest vectors between lenses, at an angle of at most 90 degrees.
std::pair<Vec2d, Vec2d> lattice_basis(const Image& white, const std::string& where) {
  const Autocorrelation correlation(white);
  std::vector<Vec2i> peaks;
  double highest = 0.0;
  for (int y = 0; y <= correlation.reach(); ++y)
    for (int x = -correlation.reach(); x <= correlation.reach(); ++x) {
      if ((y == 0 && x <= 0) || x * x + y * y < 0.8 * kLeastPitchPx * kLeastPitchPx || !correlation.is_peak(x, y)) continue;
      peaks.emplace_back(x, y);
      highest = std::max(highest, correlation.at(x, y));
    }
  constexpr double kLeastCorrelation = 0.2, kLeastShare = 0.6;
  if (!(highest > kLeastCorrelation * correlation.at(0, 0))) throw no_lens_grid(where, "the picture is not periodic");
  std::erase_if(peaks, [&](Vec2i lag) { return correlation.at(lag.x, lag.y) < kLeastShare * highest; });
  std::sort(peaks.begin(), peaks.end(),
            [](Vec2i a, Vec2i b) { return std::pair(a.x * a.x + a.y * a.y, a.x) < std::pair(b.x * b.x + b.y * b.y, b.x); });
  const Vec2d first = correlation.top(peaks.front());
  for (const Vec2i lag : peaks) {
    const Vec2d second = correlation.top(lag);
    if (std::abs(cross(first, second)) < 0.3 * glm::length(first) * glm::length(second)) continue;
    return {first, glm::dot(first, second) < 0.0 ? -second : second};
  }
  throw no_lens_grid(where, "the picture is periodic in only one direction");
}

/// Returns the direction that is closest to the axis. The direction is reversed if it points against the axis.
Vec2d nearest_to_axis(std::array<Vec2d, 3> directions, int axis) {
  Vec2d nearest(0.0);
  double most = -1.0;
  for (const Vec2d direction : directions) {
    const double along = direction[axis] / glm::length(direction);
    if (std::abs(along) > most) most = std::abs(along), nearest = along < 0.0 ? -direction : direction;
  }
  return nearest;
}

/// Returns the grid whose neighbouring lenses are `a` and `b` apart. Does not set its offset.
LensGrid grid_of_basis(Vec2d a, Vec2d b, const std::string& where) {
  const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b)), ratio = glm::length(b) / glm::length(a);
  LensGrid grid;
  if (cosine < 0.2) {
    const Vec2d row = nearest_to_axis({a, b, a}, 0);
    grid.pitch_px = glm::length(row);
    grid.row_pitch_px = std::abs(cross(a, b)) / grid.pitch_px;
    grid.rotation = std::atan2(row.y, row.x);
    return grid;
  }
  if (cosine < 0.4 || cosine > 0.6 || ratio > 1.15)
    throw no_lens_grid(where, fmt::format("its lenses are neither square nor hexagonal, with {:.4g} and {:.4g} pixels between "
                                          "neighbours at {:.4g} degrees",
                                          glm::length(a), glm::length(b), std::acos(cosine) * 180.0 / std::numbers::pi));
  const std::array<Vec2d, 3> directions{a, b, b - a};
  const Vec2d row = nearest_to_axis(directions, 0), column = nearest_to_axis(directions, 1);
  const double row_turn = std::atan2(row.y, row.x), column_turn = std::atan2(column.x, column.y);
  if (std::abs(row_turn) <= std::abs(column_turn))
    return lens_grid(glm::length(row), row_turn, {}, LensArrangement::kHexagonal);
  return lens_grid(glm::length(column), -column_turn, {}, LensArrangement::kHexagonalColumns);
}

/// Fourier coefficients of the light around the middle of a picture, under a Gaussian window and without the mean.
class LightAtFrequencies {
 public:
  LightAtFrequencies(const Image& white, double sigma_px) : middle_(0.5 * Vec2d(white.width, white.height)) {
    const int reach = static_cast<int>(std::ceil(3.0 * sigma_px));
    const Vec2i centre(middle_), first = glm::max(centre - reach, Vec2i(0)),
                                 end = glm::min(centre + reach, Vec2i(white.width, white.height));
    double sum = 0.0, window = 0.0;
    for (int y = first.y; y < end.y; ++y)
      for (int x = first.x; x < end.x; ++x) {
        const Vec2d from = Vec2d(x + 0.5, y + 0.5) - middle_;
        const double weight = std::exp(-glm::dot(from, from) / (2.0 * sigma_px * sigma_px));
        samples_.push_back({from, weight, smooth_light_at(white, x, y)});
        sum += weight * samples_.back().light, window += weight;
      }
    for (Sample& sample : samples_) sample.light = sample.weight * (sample.light - sum / window);
  }

  Vec2d middle() const { return middle_; }

  /// `frequency`: in periods per pixel.
  Complex at(Vec2d frequency) const {
    Complex sum = 0.0;
    for (const Sample& sample : samples_)
      sum += std::polar(sample.light, -2.0 * std::numbers::pi * glm::dot(frequency, sample.from));
    return sum;
  }

 private:
  struct Sample {
    Vec2d from;
    double weight, light;
  };
  Vec2d middle_;
  std::vector<Sample> samples_;
};

/// Centre of a lens near the middle, from the phase of the light at the two fundamental frequencies. Throws Error if
/// the amplitude at a half or a third of these frequencies is more than half of the larger fundamental amplitude,
/// because the lenses are then farther apart than those of `grid`.
Vec2d lens_by_phase(const Image& white, const LensGrid& grid, const std::string& where) {
  LensGrid centred = grid;
  centred.offset_px = Vec2d(0.0);
  const Vec2d e1 = lens_centre(centred, 1, 0), e2 = lens_centre(centred, 0, 1);
  const Vec2d k1 = Vec2d(e2.y, -e2.x) / cross(e1, e2), k2 = Vec2d(-e1.y, e1.x) / cross(e1, e2);
  const LightAtFrequencies light(white, 3.0 * grid.pitch_px);
  const Complex sum1 = light.at(k1), sum2 = light.at(k2);
  constexpr double kLeastShare = 0.5;
  for (const int parts : {2, 3})
    for (int i = 0; i < parts; ++i)
      for (int j = i == 0 ? 1 : 0; j < parts; ++j)
        if (std::abs(light.at((Vec2d(i) * k1 + Vec2d(j) * k2) / static_cast<double>(parts))) >
            kLeastShare * std::max(std::abs(sum1), std::abs(sum2)))
          throw no_lens_grid(where, "fewer than six lenses lie across it");
  const double turns = -0.5 / std::numbers::pi;
  return light.middle() + turns * std::arg(sum1) * e1 + turns * std::arg(sum2) * e2;
}

/// Centre of the lens near `start`, in pixels; NaN if the iteration does not converge.
Vec2d settled_centre(const Image& white, Vec2d start, double radius) {
  Vec2d centre = start;
  for (int step = 0; step < 30; ++step) {
    const int left = std::max(0, static_cast<int>(std::floor(centre.x - radius))),
              right = std::min(white.width - 1, static_cast<int>(std::ceil(centre.x + radius)));
    const int top = std::max(0, static_cast<int>(std::floor(centre.y - radius))),
              bottom = std::min(white.height - 1, static_cast<int>(std::ceil(centre.y + radius)));
    double sum = 0.0;
    Vec2d mean(0.0);
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const Vec2d from = Vec2d(x + 0.5, y + 0.5) - centre;
        const double inside = 1.0 - glm::dot(from, from) / (radius * radius);
        if (inside <= 0.0) continue;
        const double weight = inside * inside * static_cast<double>(*white.pixel(x, y));
        sum += weight, mean += weight * from;
      }
    if (!(sum > 0.0)) return Vec2d(NAN);
    const Vec2d move = 1.5 * mean / sum;
    centre += move;
    if (glm::length(centre - start) > 0.3 * radius) return Vec2d(NAN);
    if (glm::length(move) < 1e-3) return centre;
  }
  return Vec2d(NAN);
}

struct FoundLens {
  double column;  // index of the lens in its row, plus 1/2 in shifted rows
  int row;
  Vec2d centre;
};

double column_shift(const LensGrid& grid, int row) {
  return grid.arrangement == LensArrangement::kHexagonal && row % 2 != 0 ? 0.5 : 0.0;
}

/// Returns the lenses that lie completely in the picture and within `reach_px` of grid.offset_px.
std::vector<FoundLens> find_lenses(const Image& white, const LensGrid& grid, double reach_px) {
  const double radius = 0.6 * std::min(grid.pitch_px, grid.row_pitch_px);
  const int columns = static_cast<int>(std::ceil(reach_px / grid.pitch_px)) + 1,
            rows = static_cast<int>(std::ceil(reach_px / grid.row_pitch_px));
  const Vec2d last = Vec2d(white.width, white.height) - radius;
  std::vector<FoundLens> found;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const Vec2d expected = lens_centre(grid, i, j);
      if (glm::distance(expected, grid.offset_px) > reach_px) continue;
      if (glm::any(glm::lessThan(expected, Vec2d(radius))) || glm::any(glm::greaterThan(expected, last))) continue;
      const Vec2d centre = settled_centre(white, expected, radius);
      if (!std::isnan(centre.x)) found.push_back({i + column_shift(grid, j), j, centre});
    }
  return found;
}

struct LineFit {
  double sum = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  void add(double place, double value) { sum += 1.0, x += place, y += value, xx += place * place, xy += place * value; }
  double spread() const { return xx - x * x / sum; }
  double slope() const { return (xy - x * y / sum) / spread(); }
  double at_zero() const { return (y - slope() * x) / sum; }
};

/// Fits a grid by least squares. Each pass fits pitches and offset along the axes of the current rotation, and then corrects
/// the rotation by the mean skew of rows and columns. The more lenses spread along rows or columns, the more their skew counts.
LensGrid fit_grid(const std::vector<FoundLens>& lenses, LensGrid grid) {
  for (int pass = 0; pass < 6; ++pass) {
    const double c = std::cos(grid.rotation), s = std::sin(grid.rotation);
    LineFit along, up, skew_along, skew_up;
    for (const FoundLens& lens : lenses) {
      const Vec2d from = lens.centre - grid.offset_px;
      const Vec2d turned(c * from.x + s * from.y, c * from.y - s * from.x);
      along.add(lens.column, turned.x), up.add(lens.row, turned.y);
      skew_along.add(lens.column, turned.y - grid.row_pitch_px * lens.row);
      skew_up.add(lens.row, turned.x - grid.pitch_px * lens.column);
    }
    grid.pitch_px = along.slope(), grid.row_pitch_px = up.slope();
    const Vec2d moved(along.at_zero(), up.at_zero());
    grid.offset_px += Vec2d(c * moved.x - s * moved.y, s * moved.x + c * moved.y);
    const double along_weight = along.spread() * grid.pitch_px * grid.pitch_px,
                 up_weight = up.spread() * grid.row_pitch_px * grid.row_pitch_px;
    grid.rotation += (skew_along.slope() / grid.pitch_px * along_weight - skew_up.slope() / grid.row_pitch_px * up_weight) /
                     (along_weight + up_weight);
  }
  return grid;
}

double distance_to_grid(const LensGrid& grid, const FoundLens& lens) {
  const int column = static_cast<int>(std::lround(lens.column - column_shift(grid, lens.row)));
  return glm::distance(lens.centre, lens_centre(grid, column, lens.row));
}

double rms_residual(const LensGrid& grid, const std::vector<FoundLens>& lenses) {
  double sum = 0.0;
  for (const FoundLens& lens : lenses) sum += std::pow(distance_to_grid(grid, lens), 2);
  return std::sqrt(sum / static_cast<double>(lenses.size()));
}

bool spans_both_ways(const std::vector<FoundLens>& lenses) {
  if (lenses.size() < 9) return false;
  const auto [left, right] = std::minmax_element(lenses.begin(), lenses.end(),
                                                 [](const FoundLens& a, const FoundLens& b) { return a.column < b.column; });
  const auto [top, bottom] =
      std::minmax_element(lenses.begin(), lenses.end(), [](const FoundLens& a, const FoundLens& b) { return a.row < b.row; });
  return right->column - left->column >= 2.0 && bottom->row - top->row >= 2;
}

/// Finds lens centres and fits a grid to them, repeatedly over twice the extent. Does not support kHexagonalColumns.
LensGridFit grown_fit(const Image& white, LensGrid grid, const std::string& where) {
  grid.offset_px = lens_by_phase(white, grid, where);
  const double whole = std::hypot(white.width, white.height);
  std::vector<FoundLens> lenses;
  for (double reach = 3.5 * grid.pitch_px;; reach = std::min(2.0 * reach, whole)) {
    lenses = find_lenses(white, grid, reach);
    if (!spans_both_ways(lenses)) throw no_lens_grid(where, "fewer than 3x3 lens centres are found");
    grid = fit_grid(lenses, grid);
    if (reach >= whole) break;
  }
  constexpr double kOutlier = 3.0;  // maximum distance of a lens, in RMS residuals; excludes dust and clipped lenses
  const double limit = kOutlier * rms_residual(grid, lenses);
  std::erase_if(lenses, [&](const FoundLens& lens) { return distance_to_grid(grid, lens) > limit; });
  grid = fit_grid(lenses, grid);
  const LensGridFit fit{grid, static_cast<int>(lenses.size()), rms_residual(grid, lenses)};
  if (!(fit.residual_px < 0.1 * grid.pitch_px))
    throw no_lens_grid(where,
                       fmt::format("the lens centres deviate by {:.3g} pixels from the best grid, whose pitch is {:.5g} pixels",
                                   fit.residual_px, grid.pitch_px));
  return fit;
}

}  // namespace

LensGridFit estimate_lens_grid(const Image& white, const std::string& where) {
  if (std::min(white.width, white.height) < kSmallestCrop)
    throw no_lens_grid(
        where, fmt::format("it has {}x{} pixels, fewer than {}x{}", white.width, white.height, kSmallestCrop, kSmallestCrop));
  const auto [a, b] = lattice_basis(white, where);
  const LensGrid grid = grid_of_basis(a, b, where);
  if (grid.arrangement != LensArrangement::kHexagonalColumns) return grown_fit(white, grid, where);
  Image swapped(white.height, white.width, 1);
  for (int y = 0; y < white.height; ++y)
    for (int x = 0; x < white.width; ++x) *swapped.pixel(y, x) = *white.pixel(x, y);
  LensGridFit fit = grown_fit(swapped, transposed(grid), where);
  fit.grid = transposed(fit.grid);
  return fit;
}

std::string lens_grid_text(const LensGridFit& fit) {
  constexpr std::array kNames{"square", "hexagonal", "hexagonal-columns"};
  return fmt::format(
      "lens grid: {}, pitch {:.5f} x {:.5f} px, rotation {:.5f} deg, a lens at ({:.3f}, {:.3f}) px; {} lenses, residual {:.4f} "
      "px RMS",
      kNames[static_cast<std::size_t>(fit.grid.arrangement)], fit.grid.pitch_px, fit.grid.row_pitch_px,
      fit.grid.rotation * 180.0 / std::numbers::pi, fit.grid.offset_px.x, fit.grid.offset_px.y, fit.lenses, fit.residual_px);
}

}  // namespace lippmann
