// Options of the interpolation between key frames by Eljdid, Aggoun and Youssef, "Enhanced Techniques 3D Integral Images Video
// Computer Generated" (the paper). Points of key frames are projected into in-between frames.
#pragma once

namespace lippmann {

enum class SplatMode {
  /// A point is only projected to pixels below its own lens, as in the paper. A point that leaves the lens's cell is dropped.
  kLens,
  kView,  ///< a point is only projected to pixels of its own directional view
};

enum class MissedFill {
  kInterpolate,  ///< missed pixels get the colours of neighbouring pixels
  kRetrace,      ///< missed pixels are traced
  kBlack,        ///< missed pixels stay black, as in the paper's figures 4 and 5
};

}  // namespace lippmann
