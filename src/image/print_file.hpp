// Writes PNG or TIFF files for printing, with a resolution, in sRGB or in the colour space of a printer.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// ICC profile of a printer, for RGB or CMYK codes.
class OutputProfile {
 public:
  /// Throws Error naming the file if it is missing, damaged or not an output profile, or in builds without Little CMS.
  explicit OutputProfile(const std::filesystem::path& file);

  const std::string& where() const { return where_; }
  const std::vector<std::byte>& bytes() const { return bytes_; }
  bool has_inks() const { return has_inks_; }

 private:
  std::string where_;
  std::vector<std::byte> bytes_;
  bool has_inks_ = false;
};

/// Writes 8- and 16-bit codes as .png or .tiff, and floats as .exr. Converts the colours to `profile` if it is not null
/// (relative colorimetric, with black point compensation) and embeds it. CMYK profiles need .tiff. Throws Error naming the
/// file, its extension or the profile.
void write_print(const std::filesystem::path& path, const Picture& picture, double dots_per_inch,
                 const OutputProfile* profile = nullptr);

}  // namespace lippmann
