// The interface to libheif: a module (liblippmann_heic.so) that is loaded when the first HEIC picture is read. libheif brings
// the codecs of videos, which nothing else here needs. Private to src/image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct HeicPicture {
  int width = 0, height = 0;  ///< upright: turns and mirrors that the file asks for are done
  int bits = 8;               ///< of a code, 8 to 16
  bool has_alpha = false;
  std::vector<std::byte> profile = {};    ///< ICC; empty: none
  std::vector<std::uint16_t> codes = {};  ///< R, G, B and A of every pixel; empty where only the header was read
  std::string problem = {};               ///< why the picture cannot be read; empty: it was
};

class HeicModule {
 public:
  virtual ~HeicModule() = default;
  virtual HeicPicture header(std::span<const std::byte> file) const = 0;
  virtual HeicPicture decode(std::span<const std::byte> file) const = 0;
};

/// To be raised with every change of this header: a module of another version is refused.
inline constexpr int kHeicModuleVersion = 1;

}  // namespace lippmann
