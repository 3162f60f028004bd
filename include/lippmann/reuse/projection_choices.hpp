// Options of the paper's interpolation: where points may be projected, and how missed pixels are filled.
#pragma once

namespace lippmann {

enum class SplatMode {
  /// A point stays below its own lens, as in the paper. It is dropped when it leaves the lens's cell.
  kLens,
  kView,  ///< a point stays in its own directional view
};

enum class MissedFill {
  kInterpolate,  ///< missed pixels are filled from neighbouring pixels
  kRetrace,      ///< missed pixels are traced
  kBlack,        ///< missed pixels are left black, as in the paper's figures 4 and 5
};

}  // namespace lippmann
