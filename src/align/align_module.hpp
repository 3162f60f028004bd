// The interface to OpenCV: a module (liblippmann_align.so) that is loaded on first use.
//
// OpenCV is optional and loads about thirty shared libraries, so the rest of the program uses only this interface, which
// src/align/opencv implements. Pixel origin: the corner of the top-left pixel. OpenCV runs single-threaded, so that results do
// not depend on the number of threads. The functions are thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "align/grey_picture.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Feature points of an image with their descriptors.
struct Features {
  std::vector<Vec2f> places;
  std::vector<std::array<float, 128>> descriptors;
};

/// A point found in two images, as indices of its features.
struct FeatureMatch {
  std::uint32_t first = 0, second = 0;
};

class AlignModule {
 public:
  virtual ~AlignModule() = default;
  /// Returns the strongest features, at most `most`. SIFT: D. Lowe, "Distinctive image features from scale-invariant
  /// keypoints", IJCV 60(2), 2004.
  virtual Features features(const GreyPicture& picture, int most) const = 0;
  /// Returns mutual nearest neighbours that are clearly nearer than the second nearest, in the order of the first image's
  /// features.
  virtual std::vector<FeatureMatch> matches(const Features& first, const Features& second) const = 0;
  /// Returns, by semiglobal matching, how far each pixel of `first` is to the right of its position in `second`, from `least`
  /// to `most` pixels; -inf: unknown. 1 channel.
  virtual Image disparity(const GreyPicture& first, const GreyPicture& second, int least, int most) const = 0;
};

/// Increase with every change of this header. A module of another version is refused.
inline constexpr int kAlignModuleVersion = 1;

/// Loads the module on the first call. Thread-safe. Throws Error naming the module and what is missing: the module itself or a
/// library that it needs.
const AlignModule& align_module();

}  // namespace lippmann
