// How large the pictures may be that are read and written: what a hostile header may make us allocate is bounded.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann {

inline constexpr int kMaxImageSide = 1 << 16;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxImageSamples = std::int64_t{1} << 30;
inline constexpr std::uintmax_t kMaxImageFileBytes = std::uintmax_t{4} << 30;

/// Throws Error naming `where` unless the size is within those limits.
void check_image_size(const std::string& where, std::int64_t width, std::int64_t height, std::int64_t channels);

/// Throws Error if a file of `file_bytes` bytes cannot hold `picture_bytes` of samples, compressed by `ratio` at best: it is
/// truncated, or its header lies. To be called before anything of the picture's size is allocated.
void check_file_holds(const std::string& where, std::uint64_t file_bytes, std::uint64_t picture_bytes, std::uint64_t ratio);

/// What deflate makes of 258 equal bytes: 2 bits.
inline constexpr std::uint64_t kDeflateRatio = 1032;

}  // namespace lippmann
