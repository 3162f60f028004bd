// Computes the disparities of a stereo pair in four steps:
//
// 1. Features visible in both images give the range of disparities.
// 2. Semiglobal matching computes the disparities of the left image, and separately those of the right image.
// 3. Disparities that the other image contradicts are removed.
// 4. The holes are filled with the disparity of the farther neighbour in the row.
//
// Based on: H. Hirschmueller, "Stereo processing by semiglobal matching and mutual information", IEEE PAMI 30(2), 2008, as
// implemented by OpenCV: blocks instead of mutual information, five directions, steps of 1/16 pixel.
#include "align/stereo_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "align/align_module.hpp"
#include "align/similarity_fit.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr int kMatchedPx = 1600, kMatchedFeatures = 3000;
constexpr std::size_t kMinShared = 20;
/// Largest median difference of the heights of shared points without a warning, in pixels of the reduced images (at most
/// kMatchedPx per side).
constexpr double kMaxRowError = 1.0;
/// Largest accepted difference between a point's disparities in the left and in the right image, in pixels of the reduced
/// images (at most kMatchedPx per side).
constexpr double kMaxContradiction = 1.5;
constexpr float kUnknown = -std::numeric_limits<float>::infinity();

void mirror(Image& image) {
  for (int y = 0; y < image.height; ++y) std::reverse(image.pixel(0, y), image.pixel(0, y) + image.width);
}

GreyPicture mirrored(GreyPicture grey) {
  for (int y = 0; y < grey.height; ++y) {
    const auto row = grey.codes.begin() + static_cast<std::ptrdiff_t>(y) * grey.width;
    std::reverse(row, row + grey.width);
  }
  return grey;
}

struct DisparityRange {
  int least = 0, most = 0;
};

SharedPlaces places_of_pair(const GreyPicture& left, const GreyPicture& right) {
  const AlignModule& module = align_module();
  const Features first = module.features(left, kMatchedFeatures), second = module.features(right, kMatchedFeatures);
  SharedPlaces shared;
  for (const FeatureMatch& match : module.matches(first, second)) {
    shared.in_first.emplace_back(first.places[match.first]);
    shared.in_second.emplace_back(second.places[match.second]);
  }
  keep_consistent(shared, 3.0);
  return shared;
}

template <class Value>
Value value_at_share(std::vector<Value> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void warn_of_rows(const SharedPlaces& shared, const std::string& name, const Context& context) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < shared.in_first.size(); ++i)
    errors.push_back(std::abs(shared.in_first[i].y - shared.in_second[i].y));
  if (const double error = value_at_share(errors, 0.5); error > kMaxRowError)
    context.warning(
        fmt::format("Rows of the two pictures of {} differ by {:.1f} pixels, so that depth is unreliable. Align them with "
                    "`lippmann align`.",
                    name, error));
}

DisparityRange range_of_pair(const SharedPlaces& shared) {
  std::vector<double> moves;
  for (std::size_t i = 0; i < shared.in_first.size(); ++i) moves.push_back(shared.in_first[i].x - shared.in_second[i].x);
  const double least = value_at_share(moves, 0.01), most = value_at_share(moves, 0.99);
  const double margin = 4.0 + 0.15 * (most - least);
  return {static_cast<int>(std::floor(least - margin)), static_cast<int>(std::ceil(most + margin))};
}

/// Removes disparities that the other image contradicts. A point at x in this image is at x - sign * disparity in `other`.
/// sign: 1 if this is the left image, -1 if it is the right image.
void remove_contradictions(Image& disparity, const Image& other, int sign) {
  for (int y = 0; y < disparity.height; ++y)
    for (int x = 0; x < disparity.width; ++x) {
      float& d = disparity.pixel(x, y)[0];
      if (d == kUnknown) continue;
      const int there = x - sign * static_cast<int>(std::lround(d));
      const bool agrees = there >= 0 && there < other.width && std::abs(other.pixel(there, y)[0] - d) <= kMaxContradiction;
      if (!agrees) d = kUnknown;
    }
}

void fill_rows(Image& disparity, float otherwise) {
  std::vector<float> from_left(static_cast<std::size_t>(disparity.width));
  for (int y = 0; y < disparity.height; ++y) {
    float* row = disparity.pixel(0, y);
    float last = kUnknown;
    for (int x = 0; x < disparity.width; ++x)
      from_left[static_cast<std::size_t>(x)] = last = row[x] == kUnknown ? last : row[x];
    last = kUnknown;
    for (int x = disparity.width; x-- > 0;) {
      if (row[x] != kUnknown) {
        last = row[x];
        continue;
      }
      const float left = from_left[static_cast<std::size_t>(x)];
      row[x] = left == kUnknown ? last : last == kUnknown ? left : std::min(left, last);
      if (row[x] == kUnknown) row[x] = otherwise;
    }
  }
}

}  // namespace

StereoDisparity disparity_of_pair(const Picture& left, const Picture& right, const std::string& name, const Context& context) {
  const GreyPicture left_grey = grey_of(left, kMatchedPx), right_grey = grey_of(right, kMatchedPx);
  const SharedPlaces shared = places_of_pair(left_grey, right_grey);
  if (shared.in_first.size() < kMinShared)
    throw Error(name, fmt::format("its two pictures share only {} points, too few to find their depth", shared.in_first.size()),
                fmt::format("{} or more: two pictures of one scene with texture", kMinShared));
  warn_of_rows(shared, name, context);
  const DisparityRange range = range_of_pair(shared);
  const int width = std::visit([](const auto& image) { return image.width; }, left);
  const double scale = static_cast<double>(width) / left_grey.width;
  const Image found_left = align_module().disparity(left_grey, right_grey, range.least, range.most);
  Image found_right = align_module().disparity(mirrored(right_grey), mirrored(left_grey), range.least, range.most);
  mirror(found_right);
  StereoDisparity result{found_left, found_right, range.least * scale, range.most * scale};
  remove_contradictions(result.of_left, found_right, 1);
  remove_contradictions(result.of_right, found_left, -1);
  for (Image* disparity : {&result.of_left, &result.of_right}) {
    fill_rows(*disparity, static_cast<float>(range.least));
    for (float& d : disparity->data) d = static_cast<float>(d * scale);
  }
  return result;
}

}  // namespace lippmann
