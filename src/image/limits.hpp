// Limits for the size of images, which bound the memory that a malicious header can allocate.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann {

inline constexpr int kMaxImageSide = 1 << 16;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxImageSamples = std::int64_t{1} << 30;
inline constexpr std::uintmax_t kMaxImageFileBytes = std::uintmax_t{4} << 30;

void check_image_size(const std::string& where, std::int64_t width, std::int64_t height, std::int64_t channels);

/// Throws Error if a file of `file_bytes` bytes cannot contain `picture_bytes` bytes of samples at the format's largest
/// compression ratio, `ratio`. Call this before allocating memory.
void check_file_holds(const std::string& where, std::uint64_t file_bytes, std::uint64_t picture_bytes, std::uint64_t ratio);

/// Largest compression ratio of deflate: 258 equal bytes (2064 bits) take 2 bits.
inline constexpr std::uint64_t kDeflateRatio = 1032;

}  // namespace lippmann
