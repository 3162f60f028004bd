#include "lippmann/trace/aovs.hpp"

#include <algorithm>

namespace lippmann {

int channels_of(Aov aov) {
  switch (aov) {
    case Aov::kDepth:
    case Aov::kId:
    case Aov::kRayDepth:
    case Aov::kAlpha:
      return 1;
    case Aov::kMotion:
      return 2;
    default:
      return 3;
  }
}

bool FrameAovs::wants_any(bool light) const {
  for (std::size_t i = 0; i < kAovs; ++i)
    if (wanted[i] && is_light(static_cast<Aov>(i)) == light) return true;
  return false;
}

void FrameAovs::allocate(Aov aov, const Panel& panel, float value) {
  Image& image = (*this)[aov];
  image = Image(panel.width, panel.height, channels_of(aov));
  std::fill(image.data.begin(), image.data.end(), value);
}

}  // namespace lippmann
