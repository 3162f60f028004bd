// Textures ready for lookup: mip pyramids and two filters, for the lanes of a packet at once.
//
// By uv: up to 8 trilinear probes along the longer side of the footprint parallelogram, at the level that fits the shorter side
// (after: McCormack et al., "Feline", SIGGRAPH 1999, with equal weights). This avoids aliasing at 1 sample per pixel without
// blurring along the lens. Projected: Tachyon's image maps, bit for bit where possible.
#pragma once

#include <vector>

#include "device/lanes.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct DeviceTexture {
  struct Level {
    int width, height;
    std::vector<std::uint16_t> rgba;  ///< linear, 65535 = 1; 16 bits keep all 8-bit codes distinct, sRGB or not
  };
  std::vector<Level> levels;  ///< each half the size of the previous one, down to 1 x 1
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

/// Builds the mip levels by averages in linear light, or in Tachyon mode by truncating averages of bytes.
DeviceTexture make_device_texture(const Texture& texture, bool tachyon);

/// Texture points and their footprints: parallelograms of the vectors a and b in uv space.
struct UvLanes {
  Lanes u, v, a_u, a_v, b_u, b_v;
};

struct TexelLanes {
  Lanes3 color;
  Lanes alpha;
};

/// Looks up linear RGBA at uv, filtered over the footprint. Changes `texels` only in the wanted lanes. Other lanes of `uv` may
/// hold any values.
void sample_uv(const DeviceTexture& texture, const UvLanes& uv, const LaneMask& wanted, TexelLanes& texels);

/// Returns linear RGBA at one point, bilinear in one level; 0 is the finest.
Vec4f sample_point(const DeviceTexture& texture, Vec2f uv, std::size_t level = 0);

/// Looks up Tachyon's image maps (shading/projection.hpp): bilinear over (resolution - 1) texels without wrapping. Of n levels,
/// blends the two next to level blur (n - 0.9999); from level n - 2 on, uses only the last. path_length: length of the whole
/// path from the eye. Changes `color` only in the wanted lanes.
void sample_projected(const DeviceTexture& texture, const ImageProjection& projection, const Lanes3& point,
                      const Lanes& path_length, const LaneMask& wanted, Lanes3& color);

}  // namespace lippmann
