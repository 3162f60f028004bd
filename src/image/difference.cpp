#include "image/difference.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace lippmann {

Image8 difference_picture(const Image8& a, const Image8& b, int gain) {
  assert(a.width == b.width && a.height == b.height);
  Image8 difference{a.width, a.height, std::vector<unsigned char>(a.rgb.size())};
  std::transform(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), difference.rgb.begin(),
                 [gain](int x, int y) { return static_cast<unsigned char>(std::min(255, gain * std::abs(x - y))); });
  return difference;
}

}  // namespace lippmann
