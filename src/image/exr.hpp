// Writes float pictures as layers of one OpenEXR file: the film and what else is known of every pixel.
//
// One part; channels named as compositing programs expect them: R G B A, Z, and what else a frame has
// (lippmann/trace/aovs.hpp). Equal pictures give equal bytes: no time stamp is written.
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

/// All lossless.
enum class ExrCompression { kNone, kRunLength, kZipRow, kZip, kPiz };

struct ExrLayer {
  std::string name;  ///< channels are called name.channel, or just channel where name is empty
  const Image* image = nullptr;
  std::vector<std::string> channels;  ///< one per channel of the image
  ExrSample sample = ExrSample::kHalf;
};

ExrLayer film_layer(const Image& film, ExrSample sample = ExrSample::kHalf);
/// Colours of the film are multiplied by it already, as the format wants it.
ExrLayer alpha_layer(const Image& alpha, ExrSample sample = ExrSample::kHalf);
/// As float: half has not enough digits for it.
ExrLayer depth_layer(const Image& depth);

/// Text in the header of a file, beside the channels.
struct ExrAttribute {
  std::string name, text;
};

/// All images have one size, and no two channels one name. Throws Error naming the file.
void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers,
               ExrCompression compression = ExrCompression::kZip, std::span<const ExrAttribute> attributes = {});

}  // namespace lippmann
