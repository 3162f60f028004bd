// The interface to libheif. A module (liblippmann_heic.so) contains it and is loaded for the first HEIC image, because libheif
// loads video codecs that nothing else needs. Private to src/image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct HeicPicture {
  int width = 0, height = 0;  ///< size when upright, that is, after the rotations and mirrors stored in the file
  int bits = 8;               ///< bits of a code, 8 to 16
  bool has_alpha = false;
  std::vector<std::byte> profile = {};    ///< ICC profile; empty: none
  std::vector<std::uint16_t> codes = {};  ///< R, G, B and A of every pixel; empty if only the header was read
  std::string problem = {};               ///< error message; empty on success
};

/// The depth image stored beside the main picture, as in portrait photos of phones.
struct HeicDepth {
  HeicPicture image;  ///< the grey values in R, G and B; no codes if the file has no depth image
  bool is_z = false;  ///< true: codes grow with z; false: they grow with 1 / z or disparity
};

class HeicModule {
 public:
  virtual ~HeicModule() = default;
  virtual HeicPicture header(std::span<const std::byte> file) const = 0;
  virtual HeicPicture decode(std::span<const std::byte> file) const = 0;
  virtual HeicDepth depth(std::span<const std::byte> file) const = 0;
};

/// Version of this header. Increment it with every change, because a module of another version is rejected.
inline constexpr int kHeicModuleVersion = 2;

}  // namespace lippmann
