// Writes float images as layers of one OpenEXR file: the film and further per-pixel data.
//
// The file has one part. Channels have the names that compositing programs expect: R, G, B, A, Z and the names in
// lippmann/trace/aovs.hpp. The date in the header is fixed, so that equal images give equal bytes.
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

/// Lossless compression methods.
enum class ExrCompression { kNone, kRunLength, kZipRow, kZip, kPiz };

struct ExrLayer {
  /// Channels are named "name.channel", or "channel" if this name is empty.
  std::string name;
  const Image* image = nullptr;
  std::vector<std::string> channels;  ///< one name per channel of the image
  ExrSample sample = ExrSample::kHalf;
};

ExrLayer film_layer(const Image& film, ExrSample sample = ExrSample::kHalf);
/// Returns a layer for alpha. OpenEXR requires colours that are premultiplied by alpha.
ExrLayer alpha_layer(const Image& alpha, ExrSample sample = ExrSample::kHalf);
/// Returns a layer for depth. It is stored as floats, because halves have too little precision for depth.
ExrLayer depth_layer(const Image& depth);

/// A text attribute in the header of a file.
struct ExrAttribute {
  std::string name, text;
};

/// Writes layers. All images must have the same size. Channel names must be unique. Throws Error naming the file on failure.
void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers,
               ExrCompression compression = ExrCompression::kZip, std::span<const ExrAttribute> attributes = {});

}  // namespace lippmann
