// Reads the picture of a Tachyon image map as a Texture.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

/// Returns the picture as a texture with srgb = false, because Tachyon uses the bytes as linear values. Row 0 of the texture is
/// at v = 0. As in Tachyon, row 0 is the top row of PPM and JPEG images but the bottom row of TGA and PNG images. Throws Error
/// at `where` for unsupported formats (image/read_image.hpp states the size limits).
Texture read_image_map(const std::filesystem::path& file, const std::string& where);

/// Returns Tachyon's replacement for a missing image: 4 x 4 white texels.
Texture white_image_map(std::string name);

}  // namespace lippmann::tachyon
