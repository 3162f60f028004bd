// Pictures from the radiance cache mixed with a few paths a pixel. What the cache is wrong about lasts over many pixels, so
// means show it and more samples do not mend it; what paths err by averages out in means, but not in pixels. Each makes up for
// what the other is bad at.
#pragma once

#include <optional>

namespace lippmann {

struct PathMix {
  int samples = 0;      ///< paths of a pixel; 0: none are mixed in
  float weight = 0.0f;  ///< what their mean counts, 0 ... 1
};

/// Mean squared errors, of pixels and of means over blocks.
struct MixedErrors {
  float pixels = 0.0f, blocks = 0.0f;
};

/// What pictures of paths err by. Paths of a pixel are spread evenly where there are 2^k of them (transport/sampler.hpp): their
/// error falls as their number to the power `exponent`, which is 1 where it is all noise of light, and up to 2 where edges and
/// textures within pixels make it. Other numbers are those of the powers of two that they consist of, independently.
struct PathErrors {
  MixedErrors one;  ///< errors of a picture with one path a pixel
  float exponent = 1.0f;
  MixedErrors of(int samples) const;
  /// With what `samples` paths a pixel err by.
  static PathErrors with(const MixedErrors& found, int samples, float exponent);
};

/// What a mix errs by, where both parts err independently.
MixedErrors errors_of(const PathMix& mix, const MixedErrors& cached, const PathErrors& paths);

/// The fewest paths, and the weight of theirs, with which a mix errs by no more than `may`; none where even `most` are too few.
std::optional<PathMix> mix_for(const MixedErrors& cached, const PathErrors& paths, const MixedErrors& may, int most);

/// With `factor` times as many paths, at least `factor` > 1 ? one more : one fewer, and as many as are spread rather evenly:
/// one power of two, or two that follow each other. Their weight grows and falls with them, as that of a mean of independent
/// parts does.
PathMix scaled(const PathMix& mix, float factor, int most);

}  // namespace lippmann
