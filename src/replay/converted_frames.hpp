// Rendered pictures made into others for a panel, frame by frame: files, and the report.json that says their optics.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/rendered_frames.hpp"

namespace lippmann {

struct PictureConversion {
  std::filesystem::path in, out;  ///< out: a folder, pictures of the same names
  Optics optics;                  ///< those that the converted pictures are for
  std::function<Picture(const Picture&)> convert;
  std::function<nlohmann::ordered_json()> made;  ///< for the report, after all frames: what was done
};

/// Codes are written as .png, floats as they come. Returns what was written, report.json last. Throws Error; an `out` that is
/// the folder of the frames is refused. Stops between frames when context.cancelled is set.
std::vector<std::filesystem::path> convert_frames(const RenderedFrames& frames, const PictureConversion& conversion,
                                                  const Context& context);

}  // namespace lippmann
