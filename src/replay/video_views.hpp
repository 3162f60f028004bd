// The frames of a video as the views of one moment: a camera that moves sideways past its subject, or a turntable.
#pragma once

#include <filesystem>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// The first frame is the view from the left. `options.views` Nx1: N frames spread evenly over the video, the first and the
/// last included; none: every frame. `options.fit_view` applies to each. Throws Error naming the file if it cannot be read, has
/// fewer frames than that, or fewer than two; and a usage Error for views in several rows.
LightField read_video_views(const std::filesystem::path& video, const FormatOptions& options);

}  // namespace lippmann
