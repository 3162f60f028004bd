// The interface to OpenCV: a module (liblippmann_align.so) that is loaded when it is first needed.
//
// OpenCV is optional and maps some thirty shared libraries. The rest of the program knows this interface alone;
// src/align/opencv implements it. Pixel origin: the corner of the top-left pixel. OpenCV runs single-threaded in it, so that
// results do not depend on the number of threads; its functions may be called from several threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "align/grey_picture.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Places that can be found again in another picture of the scene, and what each looks like.
struct Features {
  std::vector<Vec2f> places;
  std::vector<std::array<float, 128>> looks;
};

/// A place that two pictures show: indices of their features.
struct FeatureMatch {
  std::uint32_t first = 0, second = 0;
};

class AlignModule {
 public:
  virtual ~AlignModule() = default;
  /// SIFT: D. Lowe, "Distinctive image features from scale-invariant keypoints", IJCV 60(2), 2004. The strongest `most`.
  virtual Features features(const GreyPicture& picture, int most) const = 0;
  /// Mutual nearest neighbours that are clearly nearer than the second nearest, in the order of the first picture's features.
  virtual std::vector<FeatureMatch> matches(const Features& first, const Features& second) const = 0;
  /// How far each pixel of `first` lies right of its place in `second`, from `least` to `most` pixels, by semiglobal matching;
  /// -inf: unknown. One channel.
  virtual Image disparity(const GreyPicture& first, const GreyPicture& second, int least, int most) const = 0;
};

/// To be raised with every change of this header: a module of another version is refused.
inline constexpr int kAlignModuleVersion = 1;

/// Loads the module on the first call; any thread may call it. Throws Error that names the module and what is missing: the
/// module itself or a library that it needs.
const AlignModule& align_module();

}  // namespace lippmann
