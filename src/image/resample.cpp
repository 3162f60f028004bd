#include "image/resample.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lippmann {
namespace {

struct Cover {
  int first = 0;
  std::vector<double> weights;
};

std::vector<Cover> covers_of_axis(int from, int to) {
  std::vector<Cover> covers(static_cast<std::size_t>(to));
  const double scale = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double begin = i * scale, end = (i + 1) * scale;
    Cover& cover = covers[static_cast<std::size_t>(i)];
    cover.first = std::min(static_cast<int>(begin), from - 1);
    for (int k = cover.first; k < from && (k < end || cover.weights.empty()); ++k)
      cover.weights.push_back((std::min(k + 1.0, end) - std::max(static_cast<double>(k), begin)) / scale);
  }
  return covers;
}

Image resampled_across(const Image& picture, int width) {
  const std::vector<Cover> covers = covers_of_axis(picture.width, width);
  Image result(width, picture.height, picture.channels);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < picture.channels; ++c) {
        const Cover& cover = covers[static_cast<std::size_t>(x)];
        double sum = 0.0;
        for (std::size_t k = 0; k < cover.weights.size(); ++k)
          sum += cover.weights[k] * picture.pixel(cover.first + static_cast<int>(k), y)[c];
        result.pixel(x, y)[c] = static_cast<float>(sum);
      }
  return result;
}

Image transposed(const Image& picture) {
  Image result(picture.height, picture.width, picture.channels);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) std::copy_n(picture.pixel(x, y), picture.channels, result.pixel(y, x));
  return result;
}

}  // namespace

Image resampled(const Image& picture, Vec2i size) {
  Image result = size.x == picture.width ? picture : resampled_across(picture, size.x);
  if (size.y == result.height) return result;
  return transposed(resampled_across(transposed(result), size.y));
}

}  // namespace lippmann
