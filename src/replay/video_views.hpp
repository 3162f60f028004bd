// Reads the frames of a video as the views of one light field, as if all frames showed the same moment. The camera moves
// sideways past the scene, or the scene turns in front of it.
#pragma once

#include <filesystem>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Reads the views; the first frame is the leftmost view. If options.views is Nx1, takes N frames, evenly spread from the first
/// to the last. If options.views is not given, takes every frame. Applies options.fit_view to each view. Throws Error naming
/// the file if it cannot be read, or if it has fewer than two frames or fewer than N frames. Throws a usage Error for several
/// rows of views.
LightField read_video_views(const std::filesystem::path& video, const FormatOptions& options);

}  // namespace lippmann
