// What lies behind every pixel of a frame: how deep the first hit of its centre ray is, and on what. Point images (src/reuse)
// are made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lippmann {

/// The object of a pixel whose ray met nothing.
inline constexpr std::uint32_t kNoObject = 0xffffffffu;

/// One entry per pixel, row-major from the top left. The point itself is where the pixel's ray is at that depth.
struct PrimaryPoints {
  std::vector<float> z;               ///< mm in the display frame at the frame's time; -inf where nothing was hit
  std::vector<std::uint32_t> object;  ///< index in Scene::instances; visible light l: instances.size() + l; or kNoObject

  void resize(std::size_t pixels) { z.resize(pixels), object.resize(pixels); }
};

}  // namespace lippmann
