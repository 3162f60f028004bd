// Computes the size of the panel from the number of lenses, the pixels per lens and the total size. Each kind of optics
// computes missing values from the given values (optics/optics_kind.hpp).
#pragma once

#include <cstdint>

#include "job/params.hpp"
#include "lippmann/core/math.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

/// Maximum number of pixels of a panel. A film of this size takes 25 GB. FrameLayout checks the limits of picture files.
inline constexpr std::int64_t kMaxPixels = (std::int64_t{1} << 31) - 1;

/// Maximum number of pixels per side, which is a limit of picture files and libraries.
inline constexpr int kMaxSide = 65536;

/// Returns the size of the panel. `scene_resolution` is the resolution stated in the scene's file, or {0, 0} if the file states
/// none. It is the default size of a single view. Throws a usage Error that names contradicting flags and accepted values.
PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution);

}  // namespace lippmann
