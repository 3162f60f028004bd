// Reads the frames of a video as the views of one light field. The camera must move sideways past a still scene, or the scene
// must turn in front of a still camera.
#pragma once

#include <filesystem>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// The first frame is the leftmost view. If options.views is Nx1, takes N evenly spread frames, otherwise every frame. Throws
/// Error naming the file if it cannot be read or has too few frames. Throws a usage Error for several rows of views.
LightField read_video_views(const std::filesystem::path& video, const FormatOptions& options);

}  // namespace lippmann
