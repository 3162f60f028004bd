// What this part's .cpp files share of OpenImageIO. Not to be included from anywhere else.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lippmann {

/// Largest sides and sample count that are read and written: what a hostile header may make us allocate is bounded.
inline constexpr int kMaxImageSide = 1 << 16;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxImageSamples = std::int64_t{1} << 30;

/// Throws Error naming `where` unless the size is within those limits.
void check_image_size(const std::string& where, std::int64_t width, std::int64_t height, std::int64_t channels);

/// Keeps OpenImageIO's and OpenEXR's own threads out: ours already fill the machine. To be called before using either.
void keep_oiio_single_threaded();

/// The bytes of a file of the given format ("png", "exr"). In memory, because writing failures can then be told for sure.
/// `samples` holds spec.width x spec.height pixels of the type. Throws Error naming `where`.
std::vector<std::byte> encode_with_oiio(const std::string& where, const std::string& format, const OIIO::ImageSpec& spec,
                                        OIIO::TypeDesc sample_type, const void* samples);

}  // namespace lippmann
