// Decodes the images that scene files use as textures: PNG, JPEG and WebP, distinguished by their first bytes.
#pragma once

#include <string>
#include <string_view>

#include "image/decode.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Advice for KTX2 files, whose decoder is not part of Debian.
constexpr std::string_view kKtx2Advice =
    "convert to PNG first, with gltf-transform ktxdecompress IN OUT (npm's @gltf-transform/cli; it needs KTX-Software)";

/// Returns why the image cannot be decoded ("is a GIF picture ..."), judged by its first bytes. Returns an empty text if the
/// format is supported.
std::string texture_image_problem(FileBytes encoded);

/// Returns width and height from the image's header. Throws Error at `where` for unsupported images.
Vec2i texture_size(FileBytes encoded, const std::string& where);

/// Fills the texture's width, height and rgba, starting at the top left texel. Ignores colour profiles and orientation tags;
/// alpha is not premultiplied. Throws Error at `where` for unsupported or corrupt images.
void decode_texture(FileBytes encoded, const std::string& where, Texture& into);

}  // namespace lippmann
