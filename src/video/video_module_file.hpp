// Checks whether the module that writes and reads videos is installed, without loading it.
#pragma once

namespace lippmann {

bool is_video_module_installed();

}  // namespace lippmann
