// Colours and alpha of integer pictures, pixel by pixel, as files have them. Private to src/image.
#pragma once

#include <algorithm>
#include <vector>

#include "image/oiio.hpp"

namespace lippmann {

/// R, G, B, A of every pixel.
template <class Code>
std::vector<Code> interleaved(const std::vector<Code>& rgb, const std::vector<Code>& alpha) {
  std::vector<Code> rgba(4 * alpha.size());
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    std::copy_n(&rgb[3 * i], 3, &rgba[4 * i]);
    rgba[4 * i + 3] = alpha[i];
  }
  return rgba;
}

/// Colours that are not multiplied by alpha, and are stored as they are.
inline void add_alpha(OIIO::ImageSpec& spec) {
  spec.nchannels = 4;
  spec.default_channel_names();
  spec.alpha_channel = 3;
  spec.attribute("oiio:UnassociatedAlpha", 1);
}

}  // namespace lippmann
