// How large the panel is: from lenses, pixels below a lens, and the whole size, of which any may be left to follow from the
// rest by the rule of the optics (optics/optics_kind.hpp).
#pragma once

#include <cstdint>

#include "job/params.hpp"
#include "lippmann/core/math.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

/// Panels above this are refused: 25 GB of film. What a picture's file holds, FrameLayout asks.
inline constexpr std::int64_t kMaxPixels = (std::int64_t{1} << 31) - 1;

/// And longer sides, which picture files and libraries do not hold.
inline constexpr int kMaxSide = 65536;

/// `scene_resolution`: what the scene's file asks for, the default size of a single view; {0, 0}: nothing.
/// Throws a usage Error naming the flags that contradict each other, and what would be accepted.
PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution);

}  // namespace lippmann
