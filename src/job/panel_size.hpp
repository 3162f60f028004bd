// Computes the size of the panel from the number of lenses, the pixels per lens and the total size. Each kind of optics
// computes missing values (optics/optics_kind.hpp).
#pragma once

#include <cstdint>

#include "job/params.hpp"
#include "lippmann/core/math.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

/// Maximum number of pixels of a panel. A film of this size takes 25 GB.
inline constexpr std::int64_t kMaxPixels = (std::int64_t{1} << 31) - 1;

/// Maximum number of pixels per side, a limit of picture files and libraries.
inline constexpr int kMaxSide = 65536;

/// `scene_resolution`: resolution in the scene's file, which is the default for a single view; {0, 0}: none. Throws a usage
/// Error that names contradicting flags and accepted values.
PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution);

}  // namespace lippmann
