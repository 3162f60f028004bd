// Options of the interpolation between key frames by Eljdid, Aggoun and Youssef, "Enhanced Techniques 3D Integral Images Video
// Computer Generated" (the paper).
#pragma once

namespace lippmann {

enum class SplatMode {
  /// A point is projected to pixels below its own lens, as in the paper. A point that would land below another lens is dropped.
  kLens,
  kView,  ///< a point is projected to pixels of its own directional view
};

enum class MissedFill {
  kInterpolate,  ///< pixels without a point get the colours of their neighbours
  kRetrace,      ///< pixels without a point are traced
  kBlack,        ///< pixels without a point stay black, as in the paper's figures 4 and 5
};

}  // namespace lippmann
