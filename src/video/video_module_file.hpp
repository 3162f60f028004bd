// Checks whether the module that writes and reads videos is installed.
#pragma once

namespace lippmann {

/// Returns whether the FFmpeg module (video/video_module.hpp) is installed, without loading it.
bool is_video_module_installed();

}  // namespace lippmann
