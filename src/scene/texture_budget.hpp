// Fits textures into a memory budget by halving the largest ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct TextureExtent {
  Vec2i size{1};
  /// true: the texture contains data, not colours. Among textures of equal size, data textures are halved first.
  bool is_data = true;
};

Vec2i halved(Vec2i size);

/// Returns for each texture how often to halve it so that all textures together take at most `bytes`, at 4 bytes per texel. The
/// largest textures are halved first. Among textures of equal size, data is halved before colours, and later textures before
/// earlier ones. If the budget is smaller than one texel per texture, all textures become single texels.
std::vector<int> halvings_within(std::uint64_t bytes, std::span<const TextureExtent> textures);

/// Halves the width and height of a texture by averaging 2 x 2 texels in linear light. If a side is odd, the last column or row
/// of the result covers three texels.
void halve(Texture& texture);

}  // namespace lippmann
