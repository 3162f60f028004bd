// The interface of the module liblippmann_heic.so, which reads HEIC and AVIF files with libheif. It is loaded for the first
// HEIC image, because libheif links video codecs that nothing else needs. Private to src/image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct HeicPicture {
  int width = 0, height = 0;
  int bits = 8;
  bool has_alpha = false;
  std::vector<std::byte> profile = {};    ///< empty if the file has no ICC profile
  std::vector<std::uint16_t> codes = {};  ///< R, G, B, and A if has_alpha; empty if only the header was read
  std::string problem = {};
};

struct HeicDepth {
  HeicPicture image;  ///< grey with R = G = B; `codes` is empty if the file has no depth image
  bool is_z = false;  ///< codes grow with z; otherwise with 1 / z or disparity
};

class HeicModule {
 public:
  virtual ~HeicModule() = default;
  virtual HeicPicture header(std::span<const std::byte> file) const = 0;
  virtual HeicPicture decode(std::span<const std::byte> file) const = 0;
  virtual HeicDepth depth(std::span<const std::byte> file) const = 0;
};

/// Increment this with every change of this header. Modules of another version are rejected.
inline constexpr int kHeicModuleVersion = 2;

}  // namespace lippmann
