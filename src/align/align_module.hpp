// The interface to OpenCV: a module (liblippmann_align.so) that is loaded on first use.
//
// OpenCV is optional, and loading it loads about thirty shared libraries. The origin of pixel positions is the corner of the
// top-left pixel. OpenCV runs single-threaded, so that results do not depend on the number of threads. The functions are
// thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "align/grey_picture.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

struct Features {
  std::vector<Vec2f> places;
  std::vector<std::array<float, 128>> descriptors;
};

struct FeatureMatch {
  std::uint32_t first = 0, second = 0;
};

class AlignModule {
 public:
  virtual ~AlignModule() = default;
  /// Returns at most the `most` strongest features. SIFT: D. Lowe, "Distinctive image features from scale-invariant keypoints",
  /// IJCV 60(2), 2004.
  virtual Features features(const GreyPicture& picture, int most) const = 0;
  /// Returns pairs of features with similar descriptors: each is the other's nearest neighbour and clearly nearer than the
  /// second nearest one. Pairs are in the order of the first image's features.
  virtual std::vector<FeatureMatch> matches(const Features& first, const Features& second) const = 0;
  /// Returns the disparity of each pixel of `first`: its x minus the x of the same point in `second`, in pixels. The image has
  /// one channel; -inf means unknown. Semiglobal matching searches disparities from `least` to `most` pixels.
  virtual Image disparity(const GreyPicture& first, const GreyPicture& second, int least, int most) const = 0;
};

/// Increase this number with every change of this header. A module of another version is refused.
inline constexpr int kAlignModuleVersion = 1;

/// Loads the module on the first call. Thread-safe. Throws Error naming the module and what is missing.
const AlignModule& align_module();

}  // namespace lippmann
