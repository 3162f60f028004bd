// Reads raw pictures of Lytro cameras (F01 and Illum): the light on the sensor, and the camera's lens grid.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/lens_grid.hpp"

namespace lippmann {

struct LytroRaw {
  /// Linear light on the sensor: 0 at its black level, 1 at its white level. 3 channels, without white balance.
  Image light;
  LensGrid grid;
  Vec3f gains{1.0f};             ///< white balance factors
  Mat3f srgb_from_camera{1.0f};  ///< applied after the white balance gains
  int orientation = 1;           ///< as stated in the file; not applied
};

/// Returns whether read_lytro() supports a file. It recognises .lfp and .lfr by their first bytes, and .raw (white
/// pictures) by a .txt beside it.
bool is_lytro_raw(const std::filesystem::path& path);

/// Throws Error naming the file and the key of its metadata that is missing or invalid.
LytroRaw read_lytro(const std::filesystem::path& path);

/// parse_lfr() parses a container file, and parse_lytro() packed samples with their metadata.
LytroRaw parse_lfr(std::span<const std::byte> file, const std::string& where);
LytroRaw parse_lytro(std::span<const std::byte> codes, const std::string& metadata, const std::string& where);

/// Returns the picture in sRGB encoding, after white balance and the colour matrix. The sensor's white level becomes white.
Image16 developed(const LytroRaw& raw);

}  // namespace lippmann
