#include "replay/pixel_map.hpp"

#include <algorithm>

namespace lippmann {
namespace {

template <class T>
void move_samples(const PixelMap& map, const std::vector<T>& from, std::vector<T>& to) {
  to.assign(3 * map.source.size(), T(0));
  for (std::size_t i = 0; i < map.source.size(); ++i)
    if (map.source[i] != kNoPixel) std::copy_n(&from[3 * std::size_t{map.source[i]}], 3, &to[3 * i]);
}

}  // namespace

Image apply(const PixelMap& map, const Image& picture) {
  Image result(map.width, map.height, 3);
  move_samples(map, picture.data, result.data);
  return result;
}

Picture apply(const PixelMap& map, const Picture& picture) {
  if (const auto* floats = std::get_if<Image>(&picture)) return apply(map, *floats);
  if (const auto* words = std::get_if<Image16>(&picture)) {
    Image16 result{map.width, map.height, {}};
    move_samples(map, words->rgb, result.rgb);
    return result;
  }
  Image8 result{map.width, map.height, {}};
  move_samples(map, std::get<Image8>(picture).rgb, result.rgb);
  return result;
}

}  // namespace lippmann
