// Checks whether videos can be written and read.
#pragma once

namespace lippmann {

/// Returns whether the FFmpeg module (video/video_module.hpp) is installed, without loading it.
bool is_video_module_installed();

}  // namespace lippmann
