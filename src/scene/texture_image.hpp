#pragma once

#include <string>
#include <string_view>

#include "image/decode.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

constexpr std::string_view kKtx2Advice =
    "convert to PNG first, with gltf-transform ktxdecompress IN OUT (npm's @gltf-transform/cli; it needs KTX-Software)";

/// Returns why the image cannot be decoded ("is a DDS texture ..."), judged by its first bytes. Returns an empty text for a
/// supported format.
std::string texture_image_problem(FileBytes encoded);

/// Returns the width and height from the image's header. Throws Error at `where` for unsupported images.
Vec2i texture_size(FileBytes encoded, const std::string& where);

/// Sets the texture's width, height and rgba. The first texel is the top left one. Ignores colour profiles and orientation
/// tags. Does not premultiply by alpha. Throws Error at `where` for unsupported or corrupt images.
void decode_texture(FileBytes encoded, const std::string& where, Texture& into);

}  // namespace lippmann
