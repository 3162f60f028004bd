// Interleaves colours and alpha of integer images as R, G, B, A. Private to src/image.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lippmann {

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
