// Pictures from the radiance cache mixed with a few paths a pixel. What the cache is wrong about lasts over many pixels, so
// means show it and more samples do not mend it; what paths err by averages out in means, but not in pixels. Each makes up for
// what the other is bad at.
#pragma once

#include <optional>

namespace lippmann {

struct PathMix {
  int samples = 0;      ///< paths of a pixel; 0: none are mixed in
  float weight = 0.0f;  ///< of their mean, 0 ... 1
};

/// Mean squared errors, of pixels and of means over blocks.
struct MixedErrors {
  float pixels = 0.0f, blocks = 0.0f;
};

/// What a mix errs by, where both parts err independently.
/// one_path: of a picture with one path a pixel.
MixedErrors errors_of(const PathMix& mix, const MixedErrors& cached, const MixedErrors& one_path);

/// The fewest paths, and the weight of theirs, with which a mix errs by no more than `may`; none where even `most` are too few.
std::optional<PathMix> mix_for(const MixedErrors& cached, const MixedErrors& one_path, const MixedErrors& may, int most);

/// With `factor` times as many paths, at least `factor` > 1 ? one more : one fewer; their weight grows and falls with them, as
/// that of a mean of independent parts does.
PathMix scaled(const PathMix& mix, float factor, int most);

}  // namespace lippmann
