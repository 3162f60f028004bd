// Pictures with the samples that their file stores, for programs that move pixels without touching them.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <variant>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// 8-bit codes, 16-bit codes, or floats of 3 channels.
using Picture = std::variant<Image8, Image16, Image>;

/// The colours, or grey three times. `warn`, if given, gets a sentence for each thing that the file says and that is not
/// honoured, such as a colour profile. Throws Error naming the file if it is missing, damaged, no picture, or too large.
Picture read_picture(const std::filesystem::path& path, const std::function<void(std::string_view)>& warn = {});

/// 8- and 16-bit codes as .png, floats as .exr. dots_per_inch: written into a .png; 0: not stated. Throws Error naming the
/// file, also where the ending does not suit.
void write_picture(const std::filesystem::path& path, const Picture& picture, double dots_per_inch = 0.0);

/// Linear light: codes are sRGB's, floats are linear already. What is not finite becomes 0.
Image to_linear(Picture picture);

/// The inverse: linear light (3 channels) in samples of the kind that `like` has.
Picture with_samples_like(const Picture& like, Image linear);

/// Throws Error if a picture read from `from` cannot be written to `path` without changing samples.
void check_picture_ending(const std::filesystem::path& path, const Picture& picture);

}  // namespace lippmann
