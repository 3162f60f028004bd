// Writes float images as layers of one OpenEXR file.
//
// Channels have the names that compositing programs expect: R, G, B, A, Z and those in lippmann/trace/aovs.hpp. The date in the
// header is fixed, so that equal images give equal bytes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

enum class ExrSample {
  kHalf,  ///< 11 bits of precision, values up to 65504
  kFloat,
};

enum class ExrCompression { kNone, kRunLength, kZipRow, kZip, kPiz };

struct ExrLayer {
  /// Channels are named "name.channel", or "channel" if `name` is empty.
  std::string name;
  const Image* image = nullptr;
  std::vector<std::string> channels;
  ExrSample sample = ExrSample::kHalf;
};

ExrLayer film_layer(const Image& film, ExrSample sample = ExrSample::kHalf);
/// OpenEXR requires colours that are premultiplied by alpha.
ExrLayer alpha_layer(const Image& alpha, ExrSample sample = ExrSample::kHalf);
/// Depth is stored as floats, because halves are not precise enough.
ExrLayer depth_layer(const Image& depth);

struct ExrAttribute {
  std::string name, text;
};

/// All images must have one size, and channel names must be unique. Throws Error naming the file on failure.
void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers,
               ExrCompression compression = ExrCompression::kZip, std::span<const ExrAttribute> attributes = {});

}  // namespace lippmann
