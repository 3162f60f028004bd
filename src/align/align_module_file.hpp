// Whether pictures can be aligned here.
#pragma once

namespace lippmann {

/// Whether the module that needs OpenCV (align/align_module.hpp) is where it would be loaded from; it is not loaded.
bool is_align_module_installed();

}  // namespace lippmann
