// How textures are made to fit into a budget of memory: the largest are halved until all together do.
//
// What a display shows of a texture is seldom finer than a few thousand texels across, so half the resolution is what is missed
// least; a scene that is refused shows nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// A texture as its picture has it.
struct TextureExtent {
  Vec2i size{1};        ///< texels
  bool is_data = true;  ///< no colours: of two textures of one size it is halved first
};

/// Half as wide and half as high, rounded down, at least 1.
Vec2i halved(Vec2i size);

/// How often each texture is halved, so that together they have no more than `bytes`, at 4 a texel: the largest first, of equal
/// ones data before colours and the last before the first. Where even single texels are too many, all are single texels.
std::vector<int> halvings_within(std::uint64_t bytes, std::span<const TextureExtent> textures);

/// Each texel is the mean of the 2 x 2 that it covers, in linear light, and its alpha that of theirs; the last column or row of
/// an odd number also covers the one left over. As levels of a mip pyramid are (shading/texture.hpp), but rounded to bytes.
void halve(Texture& texture);

}  // namespace lippmann
