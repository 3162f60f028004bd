#include "bench/light_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lippmann/image/encode.hpp"

namespace lippmann::bench {
namespace {

/// Estimates the mean squared error as the mean of (test - first) (test - second). The noise of the two references `first` and
/// `second` is independent, and averages to 0 in the product.
struct SquaredError {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double test, double first, double second) { sum += (test - first) * (test - second), ++count; }
  double mean() const { return count > 0 ? std::max(0.0, sum / static_cast<double>(count)) : std::nan(""); }
};

struct SecondDifference {
  double sum = 0.0;
  std::size_t count = 0;

  void add(int a, int b, int c) { sum += std::abs(a - 2 * b + c), ++count; }
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : std::nan(""); }
};

std::size_t sample_at(const Image8& picture, int x, int y) { return 3 * (static_cast<std::size_t>(y) * picture.width + x); }

bool is_edge_between(const Image8& picture, std::size_t a, std::size_t b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(picture.rgb[a + c] - picture.rgb[b + c]) >= kEdgeCodes) return true;
  return false;
}

bool is_at_edge(const Image8& stack, int x, int y, Vec2i view) {
  const std::size_t at = sample_at(stack, x, y), row = 3 * static_cast<std::size_t>(view.x);
  return (x > 0 && is_edge_between(stack, at, at - 3)) || (x + 1 < view.x && is_edge_between(stack, at, at + 3)) ||
         (y % view.y > 0 && is_edge_between(stack, at, at - row)) ||
         (y % view.y + 1 < view.y && is_edge_between(stack, at, at + row));
}

double linear_light(const Image8& picture) {
  static const std::array<double, 256> light = [] {
    std::array<double, 256> of_codes;
    for (std::size_t code = 0; code < of_codes.size(); ++code)
      of_codes[code] = linear_from_srgb(static_cast<double>(code) / 255.0);
    return of_codes;
  }();
  double sum = 0.0;
  for (const unsigned char code : picture.rgb) sum += light[code];
  return sum;
}

}  // namespace

Image8 mean_of(const Reference& reference) {
  Image8 mean = reference[0];
  for (std::size_t i = 0; i < mean.rgb.size(); ++i)
    mean.rgb[i] = static_cast<unsigned char>((reference[0].rgb[i] + reference[1].rgb[i]) / 2);
  return mean;
}

double mean_squared_error(const References& references, const Frames& test) {
  SquaredError error;
  for (std::size_t f = 0; f < references.size(); ++f)
    for (std::size_t i = 0; i < test[f].rgb.size(); ++i)
      error.add(test[f].rgb[i], references[f][0].rgb[i], references[f][1].rgb[i]);
  return error.mean();
}

std::vector<double> block_means(const Image8& stack, Vec2i view_size) {
  std::vector<double> means;
  for (int view = 0; view + view_size.y <= stack.height; view += view_size.y)
    for (int top = view; top + kBlockSide <= view + view_size.y; top += kBlockSide)
      for (int left = 0; left + kBlockSide <= view_size.x; left += kBlockSide)
        for (std::size_t c = 0; c < 3; ++c) {
          int sum = 0;
          for (int y = top; y < top + kBlockSide; ++y)
            for (int x = left; x < left + kBlockSide; ++x) sum += stack.rgb[sample_at(stack, x, y) + c];
          means.push_back(static_cast<double>(sum) / (kBlockSide * kBlockSide));
        }
  return means;
}

double block_squared_error(const References& references, const Frames& test, Vec2i view_size) {
  SquaredError error;
  for (std::size_t f = 0; f < references.size(); ++f) {
    const std::vector<double> first = block_means(references[f][0], view_size),
                              second = block_means(references[f][1], view_size), made = block_means(test[f], view_size);
    for (std::size_t i = 0; i < made.size(); ++i) error.add(made[i], first[i], second[i]);
  }
  return error.mean();
}

double edge_squared_error(const References& references, const Frames& test, Vec2i view_size) {
  SquaredError error;
  for (std::size_t f = 0; f < references.size(); ++f) {
    const Image8 mean = mean_of(references[f]);
    for (int y = 0; y < mean.height; ++y)
      for (int x = 0; x < mean.width; ++x) {
        if (!is_at_edge(mean, x, y, view_size)) continue;
        const std::size_t at = sample_at(mean, x, y);
        for (std::size_t i = at; i < at + 3; ++i) error.add(test[f].rgb[i], references[f][0].rgb[i], references[f][1].rgb[i]);
      }
  }
  return error.mean();
}

double mean_light_ratio(const References& references, const Frames& test) {
  double truth = 0.0, made = 0.0;
  for (const auto& [first, second] : references) truth += 0.5 * (linear_light(first) + linear_light(second));
  for (const Image8& frame : test) made += linear_light(frame);
  return made / truth;
}

double view_flicker(const Frames& frames, const ViewStack& views) {
  SecondDifference flicker;
  const std::size_t view = 3 * static_cast<std::size_t>(views.view_size.x) * static_cast<std::size_t>(views.view_size.y);
  for (const Image8& frame : frames)
    for (int v = 0; v + 2 < views.grid.count(); ++v) {
      if (v % views.grid.columns + 2 >= views.grid.columns) continue;
      const std::size_t first = static_cast<std::size_t>(v) * view;
      for (std::size_t i = first; i < first + view; ++i)
        flicker.add(frame.rgb[i], frame.rgb[i + view], frame.rgb[i + 2 * view]);
    }
  return flicker.mean();
}

double frame_flicker(const Frames& frames) {
  SecondDifference flicker;
  for (std::size_t f = 0; f + 2 < frames.size(); ++f)
    for (std::size_t i = 0; i < frames[f].rgb.size(); ++i)
      flicker.add(frames[f].rgb[i], frames[f + 1].rgb[i], frames[f + 2].rgb[i]);
  return flicker.mean();
}

}  // namespace lippmann::bench
