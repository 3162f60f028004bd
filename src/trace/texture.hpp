// Textures ready for lookup: mip pyramids and the two ways of filtering. Private to src/trace.
//
// By uv: a footprint parallelogram in texture space is covered by up to 8 trilinear probes along its longer side, at the level
// that fits its shorter side (after: McCormack et al., "Feline", SIGGRAPH 1999, with equal weights), which keeps 1 sample per
// pixel free of aliasing without blurring along the lens. By plane: Tachyon's image map, bit for bit where it can be.
#pragma once

#include <vector>

#include "core/math.hpp"
#include "scene/scene.hpp"

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

/// Linear RGBA at uv, filtered over the parallelogram du, dv (two vectors in uv space).
Vec4f sample_uv(const DeviceTexture& texture, Vec2f uv, Vec2f footprint_a, Vec2f footprint_b);

/// Tachyon's TEXFUNC 9: u = fraction of u_axis . (p - center) scale.x + rotate.x, v likewise with v_axis and .y; path_length is
/// the length of the whole path from the eye and chooses the level (../docs/formats: Tachyon scenes).
Vec3f sample_planar(const DeviceTexture& texture, const PlanarMapping& mapping, Vec3f point, float path_length);

}  // namespace lippmann
