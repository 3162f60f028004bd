// Reads the picture of a Tachyon image map as a Texture for Tachyon's projection formulas.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

/// Returns the image's bytes unchanged: they are display values, not encoded light (srgb = false). Row 0 is at v = 0. As in
/// Tachyon's readers, that is the top row of PPM and JPEG images and the bottom row of TGA and PNG images. Throws Error at
/// `where` for unsupported formats (image/read_image.hpp states the size limits).
Texture read_image_map(const std::filesystem::path& file, const std::string& where);

/// Returns Tachyon's substitute for a missing image: 4 x 4 white texels.
Texture white_image_map(std::string name);

}  // namespace lippmann::tachyon
