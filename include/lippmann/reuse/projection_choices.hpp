// What is chosen of the paper's interpolation: where points may land, and what becomes of pixels that none lands on.
#pragma once

namespace lippmann {

enum class SplatMode {
  kLens,  ///< a point stays below its own lens (the paper's); when it leaves the lens's cell it is dropped
  kView,  ///< a point stays in its own directional view
};

enum class MissedFill {
  kInterpolate,  ///< from neighbours
  kRetrace,      ///< traced
  kBlack,        ///< left black, as in the paper's figures 4 and 5
};

}  // namespace lippmann
