// Options of the paper's interpolation: where points may land, and how missed pixels are filled.
#pragma once

namespace lippmann {

enum class SplatMode {
  kLens,  ///< a point stays below its own lens, as in the paper; it is dropped when it leaves the lens's cell
  kView,  ///< a point stays in its own directional view
};

enum class MissedFill {
  kInterpolate,  ///< from neighbours
  kRetrace,      ///< by tracing
  kBlack,        ///< left black, as in the paper's figures 4 and 5
};

}  // namespace lippmann
