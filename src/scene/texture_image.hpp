// Decodes the pictures that scene files use as textures: PNG, JPEG and, in glTF files, WebP, told apart by their first bytes.
#pragma once

#include <string>

#include "image/decode.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Whether they begin as PNG or JPEG, which every scene format knows.
bool is_texture_image(FileBytes encoded);

/// Width and height, as its header says. Throws Error at `where` for what is not such a picture.
Vec2i texture_size(FileBytes encoded, const std::string& where);

/// Fills the texture's width, height and rgba, the top left texel first; colour profiles and orientation tags are ignored,
/// alpha is not multiplied in. Throws Error at `where` for what is not such a picture or is damaged.
void decode_texture(FileBytes encoded, const std::string& where, Texture& into);

}  // namespace lippmann
