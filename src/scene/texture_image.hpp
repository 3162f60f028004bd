// Decodes the pictures that scene files use as textures: PNG, JPEG and WebP, told apart by their first bytes.
#pragma once

#include <string>
#include <string_view>

#include "image/decode.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// How users get pictures that can be read out of KTX2 files, which need a library that Debian has not.
constexpr std::string_view kKtx2Advice =
    "convert to PNG first, with gltf-transform ktxdecompress IN OUT (npm's @gltf-transform/cli; it needs KTX-Software)";

/// Why the bytes are no picture that can be read, by how they begin: "is a GIF picture ..."; empty: they begin as one.
std::string texture_image_problem(FileBytes encoded);

/// Width and height, as its header says. Throws Error at `where` for what is not such a picture.
Vec2i texture_size(FileBytes encoded, const std::string& where);

/// Fills the texture's width, height and rgba, the top left texel first; colour profiles and orientation tags are ignored,
/// alpha is not multiplied in. Throws Error at `where` for what is not such a picture or is damaged.
void decode_texture(FileBytes encoded, const std::string& where, Texture& into);

}  // namespace lippmann
