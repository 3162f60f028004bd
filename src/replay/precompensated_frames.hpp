// Corrects finished images in advance for a display's crosstalk: `lippmann convert --precompensate`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "layout/precompensate.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

struct PrecompensateParams {
  /// An image or a folder of frames, with a report.json beside the images (replay/rendered_frames.hpp).
  std::filesystem::path in;
  std::filesystem::path out;          ///< a folder for the corrected images, which keep their names, and a report.json
  double sigma_px = 0.0;              ///< crosstalk of the display, a sigma as in optics/crosstalk.hpp
  std::optional<Optics> optics = {};  ///< optics of the images; none: read from the report.json beside them
};

struct Precompensated {
  std::vector<std::filesystem::path> written;  ///< the written files, with report.json last
  Precompensation bound;                       ///< mean share of clipped samples and largest residual over all frames
};

/// Corrects all frames. Integer samples keep their number of bits. Throws Error naming the flag or file. Stops between frames
/// if context.cancelled is set.
Precompensated precompensate_frames(const PrecompensateParams& params, const Context& context);

}  // namespace lippmann
