// How large the panel is: from lenses, pixels below a lens, and the whole size, of which any may be left to follow from the
// rest.
//
// For lens arrays width = lenses across x pixels below a lens; where both and the size are given, they must agree to the pixel.
// By default: 64 lenses of 8 pixels, square. Quilts: 8x6 views of 256x256 pixels.
#pragma once

#include <cstdint>

#include "job/params.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

/// Panels above this are refused: 25 GB of film. What a picture's file holds, FrameLayout asks.
inline constexpr std::int64_t kMaxPixels = (std::int64_t{1} << 31) - 1;

/// And longer sides, which picture files and libraries do not hold.
inline constexpr int kMaxSide = 65536;

struct PanelSize {
  int width = 512, height = 512;  ///< pixels
  float lens_pixels = 8.0f;       ///< across a lens, along a pixel row; lens arrays only
};

/// Columns and rows of views: as given, or 8x6.
Extent<int> quilt_views(const RenderParams& params);

/// `scene_resolution`: what the scene's file asks for, the default size of a single view; {0, 0}: nothing.
/// Throws a usage Error naming the flags that contradict each other, and what would be accepted.
PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution);

}  // namespace lippmann
