// Decodes the pictures that scene files use as textures: PNG, JPEG and, in glTF files, WebP, told apart by their first bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// How much decoded pictures may be.
struct TextureBudget {
  int longest_side = 0;     ///< texels
  std::uint64_t bytes = 0;  ///< of all pictures together
  std::uint64_t left = 0;   ///< of these, still to be spent
};

/// Whether they begin as PNG or JPEG, which every scene format knows.
bool is_texture_image(std::span<const std::byte> encoded);

/// Fills the texture's width, height and rgba, the top left texel first; colour profiles and orientation tags are ignored,
/// alpha is not multiplied in. Throws Error at `where` for what is not such a picture, is damaged or beyond the budget.
void decode_texture(std::span<const std::byte> encoded, const std::string& where, TextureBudget& budget, Texture& into);

}  // namespace lippmann
