// Corrects rendered or recorded images with inverted depth: `lippmann convert --rotate-elemental` and `--spoc`.
//
// Both move pixels without changing them, so integer samples keep their number of bits.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "replay/spoc.hpp"

namespace lippmann {

struct OrthoscopicParams {
  std::filesystem::path in;   ///< an image, or a folder of frames, beside its report.json (replay/rendered_frames.hpp)
  std::filesystem::path out;  ///< a folder for images of the same names and a report.json with their optics
  std::optional<SpocParams> spoc = {};  ///< none: rotate elemental images
  // Lens array of the display; none: as the recording array.
  std::optional<double> lens_pitch_mm = {}, gap_mm = {};
  std::optional<int> lens_pixels = {};
};

/// Converts all frames. Returns the written files, report.json last. Throws Error naming the flag or file, also if `out` is the
/// folder of `in`. Stops between frames if context.cancelled is set.
std::vector<std::filesystem::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context);

}  // namespace lippmann
