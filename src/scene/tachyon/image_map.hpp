#pragma once

#include <filesystem>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

/// Returns the picture as a texture with srgb = false, because Tachyon uses the bytes as linear values. As in Tachyon, row 0 is
/// the top row of PPM and JPEG images but the bottom row of TGA and PNG images. Throws Error at `where` for unsupported
/// formats.
Texture read_image_map(const std::filesystem::path& file, const std::string& where);

Texture white_image_map(std::string name);

}  // namespace lippmann::tachyon
