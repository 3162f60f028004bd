// Depth and object of each pixel's first hit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lippmann {

inline constexpr std::uint32_t kNoObject = 0xffffffffu;

/// One entry per pixel, row by row from the top left.
struct PrimaryPoints {
  std::vector<float> z;               ///< z in mm of the display frame; -inf without a hit
  std::vector<std::uint32_t> object;  ///< index in Scene::instances, or instances.size() + l for visible light l, or kNoObject

  void resize(std::size_t pixels) { z.resize(pixels), object.resize(pixels); }
};

}  // namespace lippmann
