// The depth and object of each pixel's first hit. Point images (src/reuse) are made from these values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lippmann {

/// The object of a pixel whose ray hit nothing.
inline constexpr std::uint32_t kNoObject = 0xffffffffu;

/// One entry per pixel, row-major from the top left. The point itself lies on the pixel's ray at depth z.
struct PrimaryPoints {
  std::vector<float> z;               ///< mm in the display frame at the frame's time; -inf without a hit
  std::vector<std::uint32_t> object;  ///< index in Scene::instances; visible light l has instances.size() + l; or kNoObject

  void resize(std::size_t pixels) { z.resize(pixels), object.resize(pixels); }
};

}  // namespace lippmann
