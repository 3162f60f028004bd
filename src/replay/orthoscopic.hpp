// Corrects images with inverted depth: `lippmann convert --rotate-elemental` and `--spoc`. Both conversions move pixels without
// changing their colours.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "replay/spoc.hpp"

namespace lippmann {

struct OrthoscopicParams {
  /// An image or a folder of frames, with a report.json beside the images.
  std::filesystem::path in;
  /// Folder for report.json and the converted images, which keep their names.
  std::filesystem::path out;
  std::optional<SpocParams> spoc = {};  ///< parameters of --spoc; none for --rotate-elemental
  // Lens array of the display; none: the recording array.
  std::optional<double> lens_pitch_mm = {}, gap_mm = {};
  std::optional<int> lens_pixels = {};
};

/// Returns the written files, with report.json last. Throws Error naming the flag or file. Stops between frames if
/// context.cancelled is set.
std::vector<std::filesystem::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context);

}  // namespace lippmann
