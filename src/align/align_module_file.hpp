// Determines whether image alignment is available.
#pragma once

namespace lippmann {

/// Returns whether the OpenCV module (align/align_module.hpp) is installed, without loading it.
bool is_align_module_installed();

}  // namespace lippmann
