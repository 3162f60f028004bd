// Whether videos can be written and read here.
#pragma once

namespace lippmann {

/// Whether the module that needs FFmpeg (video/video_module.hpp) is where it would be loaded from; it is not loaded.
bool is_video_module_installed();

}  // namespace lippmann
