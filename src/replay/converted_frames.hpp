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
  std::filesystem::path in, out;  ///< out: a folder for images of the same names
  Optics optics;                  ///< optics of the converted images
  std::function<Picture(const Picture&)> convert;
  std::function<nlohmann::ordered_json()> made;  ///< called after all frames; describes the conversion for the report
};

/// Converts the frames of `frames`. Writes integer samples as .png and floats in their own format. Returns the written files,
/// report.json last. Throws Error, also if `out` is the folder of the frames. Stops between frames if context.cancelled is set.
std::vector<std::filesystem::path> convert_frames(const RenderedFrames& frames, const PictureConversion& conversion,
                                                  const Context& context);

}  // namespace lippmann
