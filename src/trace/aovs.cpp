#include "lippmann/trace/aovs.hpp"

#include <algorithm>

namespace lippmann {

bool FrameAovs::wants_any(AovOrigin origin) const {
  for (std::size_t i = 0; i < kAovs; ++i)
    if (wanted[i] && kAovInfos[i].origin == origin) return true;
  return false;
}

void FrameAovs::allocate(Aov aov, Vec2i film_size) {
  Image& image = (*this)[aov];
  image = Image(film_size.x, film_size.y, channels_of(aov));
  std::fill(image.data.begin(), image.data.end(), info_of(aov).nothing);
}

}  // namespace lippmann
