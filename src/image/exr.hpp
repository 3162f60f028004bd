// Writes float pictures as layers of one OpenEXR file: the film and what else is known of every pixel.
//
// One part; channels named as compositing programs expect them: R G B, Z, N.X N.Y N.Z, P.X P.Y P.Z, id, albedo.R, motion.X, ...
// Equal pictures give equal bytes: no time stamp is written.
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

/// The layers of a frame. Depth, position, motion and ids are stored as float: half has not enough digits for them.
ExrLayer film_layer(const Image& film, ExrSample sample = ExrSample::kHalf);
/// Colours of the film are multiplied by it already, as the format wants it.
ExrLayer alpha_layer(const Image& alpha, ExrSample sample = ExrSample::kHalf);
ExrLayer depth_layer(const Image& depth);
ExrLayer normal_layer(const Image& normal);
ExrLayer object_id_layer(const Image& object_id);
ExrLayer position_layer(const Image& position);
ExrLayer ray_depth_layer(const Image& ray_depth);
ExrLayer motion_layer(const Image& motion);
/// `name` with the channels R, G and B.
ExrLayer color_layer(std::string name, const Image& color);

/// Text in the header of a file, beside the channels.
struct ExrAttribute {
  std::string name, text;
};

/// All images have one size, and no two channels one name. Throws Error naming the file.
void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers,
               ExrCompression compression = ExrCompression::kZip, std::span<const ExrAttribute> attributes = {});

}  // namespace lippmann
