// Compares a picture with a reference, and saves both pictures if they differ. Rounding may move the edges of objects,
// so a given fraction of pixels may differ by more than a tolerance, but no pixel by more than a hard limit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "image/png.hpp"

namespace lippmann::test {

struct ImageTolerance {
  int per_pixel = 0;     ///< largest difference of a channel, in codes
  double share = 0.0;    ///< fraction of pixels that may exceed `per_pixel`
  int hard_limit = 255;  ///< largest difference of any pixel, in codes
};

namespace detail {

/// Creates a folder for pictures of failed comparisons, in $LIPPMANN_TEST_OUTPUT or in test-failures in the current
/// folder.
inline std::filesystem::path evidence_folder() {
  const char* given = std::getenv("LIPPMANN_TEST_OUTPUT");
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string test = info ? std::string(info->test_suite_name()) + "." + info->name() : "no-test";
  std::filesystem::path folder = std::filesystem::path(given ? given : "test-failures") / test;
  std::filesystem::create_directories(folder);
  return folder;
}

/// Returns min(255, gain |a - b|) of each code.
inline Image8 difference_picture(const Image8& a, const Image8& b, int gain) {
  Image8 difference = a;
  std::transform(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), difference.rgb.begin(),
                 [gain](int x, int y) { return static_cast<unsigned char>(std::min(255, gain * std::abs(x - y))); });
  return difference;
}

inline std::string leave_evidence(const Image8& image, const Image8& reference) {
  const std::filesystem::path folder = evidence_folder();
  write_png(folder / "image.png", image);
  write_png(folder / "reference.png", reference);
  write_png(folder / "difference.png", difference_picture(image, reference, 8));
  return "see image.png, reference.png and difference.png (8 times) in " + std::filesystem::absolute(folder).string();
}

inline int pixel_difference(const Image8& a, const Image8& b, std::size_t pixel) {
  int largest = 0;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) largest = std::max(largest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
  return largest;
}

}  // namespace detail

inline testing::AssertionResult images_match(const Image8& image, const Image8& reference,
                                             const ImageTolerance& tolerance = {}) {
  if (image.width != reference.width || image.height != reference.height)
    return testing::AssertionFailure() << image.width << " x " << image.height << " pixels instead of " << reference.width
                                       << " x " << reference.height;
  std::size_t beyond = 0, worst_pixel = 0;
  int worst = 0;
  const std::size_t pixels = reference.rgb.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int difference = detail::pixel_difference(image, reference, i);
    beyond += difference > tolerance.per_pixel ? 1 : 0;
    if (difference > worst) worst = difference, worst_pixel = i;
  }
  const double share = static_cast<double>(beyond) / static_cast<double>(pixels);
  if (share <= tolerance.share && worst <= tolerance.hard_limit) return testing::AssertionSuccess();
  return testing::AssertionFailure() << beyond << " of " << pixels << " pixels (" << share << ") differ by more than "
                                     << tolerance.per_pixel << " codes (allowed share " << tolerance.share << "); the worst, ("
                                     << worst_pixel % reference.width << ", " << worst_pixel / reference.width << "), by "
                                     << worst << " (limit " << tolerance.hard_limit << "); "
                                     << detail::leave_evidence(image, reference);
}

}  // namespace lippmann::test
