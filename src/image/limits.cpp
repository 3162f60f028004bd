#include "image/limits.hpp"

#include <fmt/format.h>

#include "lippmann/core/error.hpp"

namespace lippmann {

void check_image_size(const std::string& where, std::int64_t width, std::int64_t height, std::int64_t channels) {
  const bool sides = width >= 1 && height >= 1 && channels >= 1 && width <= kMaxImageSide && height <= kMaxImageSide;
  if (sides && width * height <= kMaxImagePixels && channels <= kMaxImageSamples / (width * height)) return;
  throw Error(where, fmt::format("a picture of {} x {} pixels with {} channels is empty or too large", width, height, channels),
              fmt::format("sides of 1 to {} pixels, at most {} pixels and {} samples", kMaxImageSide, kMaxImagePixels,
                          kMaxImageSamples));
}

void check_file_holds(const std::string& where, std::uint64_t file_bytes, std::uint64_t picture_bytes, std::uint64_t ratio) {
  if (picture_bytes / ratio <= file_bytes) return;
  throw Error(where,
              fmt::format("cannot be read as a picture: the file is truncated; its {} bytes cannot hold {} bytes of samples",
                          file_bytes, picture_bytes));
}

}  // namespace lippmann
