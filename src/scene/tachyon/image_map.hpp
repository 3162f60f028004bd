// Reads the picture of an image map as the Texture that Tachyon's formulas index.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

/// The picture's bytes, unchanged: they are display values, not encoded light (srgb = false). Row 0 is the row at v = 0, which
/// for PPM and JPEG is the picture's top row and for TGA and PNG its bottom row, as Tachyon's readers have it.
/// Throws Error at `where` for what is not a picture in one of these formats (image/read_image.hpp says how large).
Texture read_image_map(const std::filesystem::path& file, const std::string& where);

/// What Tachyon shows where a picture is missing: 4 x 4 white texels.
Texture white_image_map(std::string name);

}  // namespace lippmann::tachyon
