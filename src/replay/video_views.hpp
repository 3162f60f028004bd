// Reads the frames of a video as views of one moment: a camera that moves sideways past its subject, or a turntable.
#pragma once

#include <filesystem>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Reads the views; the first frame is the leftmost view. options.views Nx1: N frames, evenly spread from the first to the
/// last; none: every frame. options.fit_view is applied to each. Throws Error naming the file if it cannot be read or has fewer
/// than two or than N frames, and a usage Error for several rows of views.
LightField read_video_views(const std::filesystem::path& video, const FormatOptions& options);

}  // namespace lippmann
