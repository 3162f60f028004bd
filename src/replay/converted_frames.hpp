// Converts rendered images to other images for a panel, frame by frame, and writes a report.json with their optics.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_frames.hpp"

namespace lippmann {

struct PictureConversion {
  std::filesystem::path in, out;
  Optics optics;
  std::function<Picture(const Picture&)> convert;
  /// Called after all frames. Returns a description of the conversion for the report.
  std::function<nlohmann::ordered_json()> made;
};

/// Converts and writes all frames: integer samples as .png, floats in the format of the input. Returns the written files, with
/// report.json last. Throws Error, also if `out` is the folder of the frames. Stops between frames if context.cancelled is set.
std::vector<std::filesystem::path> convert_frames(const RenderedFrames& frames, const PictureConversion& conversion,
                                                  const Context& context);

}  // namespace lippmann
