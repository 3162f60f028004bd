// The raw picture of Lytro's cameras (F01 and Illum): colours, and the lens grid that the camera states.
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
  /// What the sensor saw, 0 at its black level and 1 at its white level, linear, 3 channels, without white balance.
  Image light;
  LensGrid grid;
  Vec3f gains{1.0f};             ///< white balance
  Mat3f srgb_from_camera{1.0f};  ///< applied after it
  int orientation = 1;           ///< as the file states it; not applied
};

/// Whether read_lytro reads such a file: .lfp and .lfr by their first bytes; .raw (white pictures) by a .txt beside it.
bool is_lytro_raw(const std::filesystem::path& path);

/// Throws Error naming the file and the key.
LytroRaw read_lytro(const std::filesystem::path& path);

/// The same of a container's bytes, and of packed codes with their metadata.
LytroRaw parse_lfr(std::span<const std::byte> file, const std::string& where);
LytroRaw parse_lytro(std::span<const std::byte> codes, const std::string& metadata, const std::string& where);

/// White balance and colours applied: codes of sRGB. What is as bright as the sensor's white stays white.
Image16 developed(const LytroRaw& raw);

}  // namespace lippmann
