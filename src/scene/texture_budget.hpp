// Fits textures into a memory budget by halving the largest ones.
//
// A display rarely shows more than a few thousand texels across, so reduced resolution is better than refusing the scene.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The size of a texture before reduction.
struct TextureExtent {
  Vec2i size{1};        ///< width and height in texels
  bool is_data = true;  ///< data instead of colours; halved first among textures of equal size
};

/// Returns half the width and height, rounded down, at least 1.
Vec2i halved(Vec2i size);

/// Returns how often to halve each texture so that all together take at most `bytes` at 4 bytes per texel. Halves the largest
/// textures first; among textures of equal size, data before colours and later textures before earlier ones. If the budget is
/// smaller than one texel per texture, all become single texels.
std::vector<int> halvings_within(std::uint64_t bytes, std::span<const TextureExtent> textures);

/// Halves a texture by averaging 2 x 2 texels, colours in linear light. With odd sizes, the last column or row of the result
/// covers three texels. The result equals a level of a mip pyramid (shading/texture.hpp), but is rounded to bytes.
void halve(Texture& texture);

}  // namespace lippmann
