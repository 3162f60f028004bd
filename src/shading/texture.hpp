// Textures ready for lookup: mip pyramids and the two ways of filtering, for the lanes of a packet at once.
//
// By uv: a footprint parallelogram in texture space is covered by up to 8 trilinear probes along its longer side, at the level
// that fits its shorter side (after: McCormack et al., "Feline", SIGGRAPH 1999, with equal weights), which keeps 1 sample per
// pixel free of aliasing without blurring along the lens. Projected: Tachyon's image maps, bit for bit where they can be.
#pragma once

#include <vector>

#include "device/lanes.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct DeviceTexture {
  struct Level {
    int width, height;
    std::vector<std::uint16_t> rgba;  ///< linear, 65535 = 1: finer than any 8-bit code, sRGB or not
  };
  std::vector<Level> levels;  ///< each half the size of the one before, down to 1 x 1
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

/// Averages in linear light, or, for scenes after Tachyon, truncating averages of the bytes.
DeviceTexture make_device_texture(const Texture& texture, bool tachyon);

/// Points of a texture and the footprints around them: parallelograms of the vectors a and b in uv space.
struct UvLanes {
  Lanes u, v, a_u, a_v, b_u, b_v;
};

struct TexelLanes {
  Lanes3 color;
  Lanes alpha;
};

/// Linear RGBA at uv, filtered over the footprint; `texels` changes in the wanted lanes only. What the other lanes hold may be
/// anything.
void sample_uv(const DeviceTexture& texture, const UvLanes& uv, const LaneMask& wanted, TexelLanes& texels);

/// Linear RGBA at one point, bilinear, of one level; 0 is the finest.
Vec4f sample_point(const DeviceTexture& texture, Vec2f uv, std::size_t level = 0);

/// Tachyon's image maps (trace/projection.hpp): bilinear over (resolution - 1) texels without wrapping, between the two levels
/// of n that blur (n - 0.9999) falls between, the last level from n - 2 on. path_length: the whole path's, from the eye.
/// `color` changes in the wanted lanes only.
void sample_projected(const DeviceTexture& texture, const ImageProjection& projection, const Lanes3& point,
                      const Lanes& path_length, const LaneMask& wanted, Lanes3& color);

}  // namespace lippmann
