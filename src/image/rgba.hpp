// Interleaves the colours and alpha of integer images for image files. Private to src/image.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lippmann {

/// Returns R, G, B, A of every pixel.
template <class Code>
std::vector<Code> interleaved(const std::vector<Code>& rgb, const std::vector<Code>& alpha) {
  std::vector<Code> rgba(4 * alpha.size());
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    std::copy_n(&rgb[3 * i], 3, &rgba[4 * i]);
    rgba[4 * i + 3] = alpha[i];
  }
  return rgba;
}

}  // namespace lippmann
