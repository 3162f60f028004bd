// Mip pyramids and texture lookups for the lanes of a packet.
//
// Textures with uv coordinates: up to 8 trilinear probes lie along the longer side of the footprint, which is a parallelogram.
// The mip level fits the shorter side. After: McCormack et al., "Feline", SIGGRAPH 1999. We deviate: all probes have the same
// weight.
//
// Projected textures: Tachyon's image maps, bit-identical where possible.
#pragma once

#include <vector>

#include "device/lanes.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct DeviceTexture {
  struct Level {
    int width, height;
    /// Linear codes; 65535 stands for 1. With 16 bits, all 8-bit input codes stay distinct, linear or sRGB-encoded.
    std::vector<std::uint16_t> rgba;
  };
  std::vector<Level> levels;
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

/// Builds the mip levels by averages in linear light. In Tachyon mode, bytes are averaged and truncated instead.
DeviceTexture make_device_texture(const Texture& texture, bool tachyon);

struct UvLanes {
  Lanes u, v, a_u, a_v, b_u, b_v;
};

struct TexelLanes {
  Lanes3 color;
  Lanes alpha;
};

/// Looks up linear RGBA in the wanted lanes, filtered over the footprints. Other lanes of `texels` keep their values, and other
/// lanes of `uv` may hold any values.
void sample_uv(const DeviceTexture& texture, const UvLanes& uv, const LaneMask& wanted, TexelLanes& texels);

/// Returns linear RGBA at one point of a level, by bilinear interpolation. Level 0 is the finest.
Vec4f sample_point(const DeviceTexture& texture, Vec2f uv, std::size_t level = 0);

/// Looks up Tachyon's image maps (shading/projection.hpp) in the wanted lanes; other lanes of `color` keep their values.
/// path_length: length of the whole path from the eye, for each lane.
/// 1. Within a level, interpolation is bilinear over (resolution - 1) texels, without wrapping.
/// 2. The level is blur * (n - 0.9999) for n levels. The blur, 0 to 1, grows with the path length. The two nearest levels are
///    blended, but from level n - 2 on, only the last level is used.
void sample_projected(const DeviceTexture& texture, const ImageProjection& projection, const Lanes3& point,
                      const Lanes& path_length, const LaneMask& wanted, Lanes3& color);

}  // namespace lippmann
