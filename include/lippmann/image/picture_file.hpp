// Reads and writes images with the sample type of their file, for commands that move pixels without changing their values.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <variant>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// The pixels of an image file: 8-bit codes, 16-bit codes, or floats with 3 channels.
using Picture = std::variant<Image8, Image16, Image>;

/// Reads the colours of an image. Grey is repeated in three channels. If `warn` is given, it is called with a sentence for each
/// ignored property of the file, such as a colour profile. Throws Error naming the file if it is missing, damaged, too large,
/// or not an image.
Picture read_picture(const std::filesystem::path& path, const std::function<void(std::string_view)>& warn = {});

/// Writes 8- and 16-bit codes as .png, floats as .exr. Stores `dots_per_inch` in a .png unless it is 0. Throws Error naming the
/// file if it cannot be written or has the wrong extension.
void write_picture(const std::filesystem::path& path, const Picture& picture, double dots_per_inch = 0.0);

/// Converts to linear light: integer samples are sRGB codes, floats are linear. Values that are not finite become 0.
Image to_linear(Picture picture);

/// Converts linear light (3 channels) to the sample type of `like`; the inverse of to_linear().
Picture with_samples_like(const Picture& like, Image linear);

/// Throws Error if write_picture() would have to change the samples of `picture` for the extension of `path`.
void check_picture_ending(const std::filesystem::path& path, const Picture& picture);

}  // namespace lippmann
