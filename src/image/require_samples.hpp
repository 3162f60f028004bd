// Checks that images from outside the library have as many samples as their size requires.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <variant>

#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

inline void require_samples(std::size_t samples, int width, int height, int channels, const std::string& what) {
  const bool has_size = width > 0 && height > 0 && channels > 0;
  const std::size_t wanted = has_size ? std::size_t(width) * std::size_t(height) * std::size_t(channels) : 0;
  if (has_size && samples == wanted) return;
  throw Error(what, fmt::format("holds {} samples for {}x{} pixels of {} channels", samples, width, height, channels),
              has_size ? fmt::format("{}", wanted) : "a picture of at least one pixel");
}

inline void require_samples(const Image& image, const std::string& what) {
  require_samples(image.data.size(), image.width, image.height, image.channels, what);
}

/// `Codes` is Image8 or Image16, whose alpha may be empty.
template <class Codes>
void require_samples(const Codes& codes, const std::string& what) {
  require_samples(codes.rgb.size(), codes.width, codes.height, 3, what);
  if (!codes.alpha.empty()) require_samples(codes.alpha.size(), codes.width, codes.height, 1, what + ", alpha");
}

inline void require_samples(const Picture& picture, const std::string& what) {
  std::visit([&](const auto& image) { require_samples(image, what); }, picture);
}

inline void require_channels(const Image& image, int channels, const std::string& what) {
  if (image.channels != channels)
    throw Error(what, fmt::format("has {} channels", image.channels), fmt::format("{}", channels));
}

}  // namespace lippmann
