// Corrects rendered or recorded images with inverted depth: `lippmann convert --rotate-elemental` and `--spoc`.
//
// Both conversions move pixels without changing them, so that integer samples keep their number of bits.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "replay/spoc.hpp"

namespace lippmann {

struct OrthoscopicParams {
  /// An image or a folder of frames, with a report.json beside the images (replay/rendered_frames.hpp).
  std::filesystem::path in;
  /// A folder for the converted images, which keep their names, and a report.json with their optics.
  std::filesystem::path out;
  std::optional<SpocParams> spoc = {};  ///< parameters of --spoc; none: elemental images are rotated
  // Lens array of the display; none: equal to the recording array.
  std::optional<double> lens_pitch_mm = {}, gap_mm = {};
  std::optional<int> lens_pixels = {};
};

/// Converts all frames. Returns the written files, with report.json last. Throws Error naming the flag or file, also if `out`
/// is the folder of `in`. Stops between frames if context.cancelled is set.
std::vector<std::filesystem::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context);

}  // namespace lippmann
