// Writes float images as layers of one OpenEXR file: the film and further per-pixel data.
//
// The file has one part. Channels have the names that compositing programs expect: R G B A, Z, and those of
// lippmann/trace/aovs.hpp. Equal images give equal bytes: no time stamp is written.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

enum class ExrSample {
  kHalf,  ///< 11 bits of precision, up to 65504
  kFloat,
};

/// Lossless compression methods.
enum class ExrCompression { kNone, kRunLength, kZipRow, kZip, kPiz };

struct ExrLayer {
  std::string name;  ///< channels are named name.channel, or channel if name is empty
  const Image* image = nullptr;
  std::vector<std::string> channels;  ///< one per channel of the image
  ExrSample sample = ExrSample::kHalf;
};

ExrLayer film_layer(const Image& film, ExrSample sample = ExrSample::kHalf);
/// Returns a layer of alpha. The film's colours are already multiplied by alpha, as the format requires.
ExrLayer alpha_layer(const Image& alpha, ExrSample sample = ExrSample::kHalf);
/// Returns a layer of depth as floats, because half precision is too low.
ExrLayer depth_layer(const Image& depth);

/// Text in the header of a file, beside the channels.
struct ExrAttribute {
  std::string name, text;
};

/// Writes layers. All images must have the same size, and channel names must be unique. Throws Error naming the file.
void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers,
               ExrCompression compression = ExrCompression::kZip, std::span<const ExrAttribute> attributes = {});

}  // namespace lippmann
