// Corrects finished images for a display whose pixels leak light to their neighbours: `lippmann convert --precompensate`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/precompensate.hpp"

namespace lippmann {

struct PrecompensateParams {
  /// An image or a folder of frames, with a report.json beside the images.
  std::filesystem::path in;
  std::filesystem::path out;          ///< folder for report.json and the images, which keep their names
  double sigma_px = 0.0;              ///< sigma of the crosstalk, see optics/crosstalk.hpp
  std::optional<Optics> optics = {};  ///< optics of the images; none: from the report.json beside them
};

struct Precompensated {
  std::vector<std::filesystem::path> written;
  Precompensation bound;  ///< mean clipped fraction and largest residual of all frames
};

/// Corrects and writes all frames. Integer samples keep their number of bits. Throws Error naming the flag or file. Stops
/// between frames if context.cancelled is set.
Precompensated precompensate_frames(const PrecompensateParams& params, const Context& context);

}  // namespace lippmann
