// Reads and writes images with the sample type of their file.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <variant>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// 8-bit codes, 16-bit codes, or floats with 3 channels.
using Picture = std::variant<Image8, Image16, Image>;

/// Reads the colours of an image; grey is repeated in three channels. `warn` is called with a sentence for each ignored
/// property of the file. Throws Error naming the file if it is missing, damaged, too large, or not an image.
Picture read_picture(const std::filesystem::path& path, const std::function<void(std::string_view)>& warn = {});

/// Writes 8- and 16-bit codes as .png, floats as .exr. A .png stores `dots_per_inch` unless it is 0. Throws Error naming the
/// file if it cannot be written or has the wrong extension.
void write_picture(const std::filesystem::path& path, const Picture& picture, double dots_per_inch = 0.0);

/// Converts to linear light: integer samples are sRGB codes, floats are linear. Values that are not finite become 0.
Image to_linear(Picture picture);

/// Converts linear light (3 channels) to the sample type of `like`, the inverse of to_linear().
Picture with_samples_like(const Picture& like, Image linear);

/// Throws Error if the extension of `path` cannot store the samples of `picture`.
void check_picture_ending(const std::filesystem::path& path, const Picture& picture);

}  // namespace lippmann
