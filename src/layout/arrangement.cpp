#include "lippmann/layout/arrangement.hpp"

#include <algorithm>

namespace lippmann {

Arrangement::Arrangement(const ViewLayout& from, const ViewLayout& to, Vec2i picture, const std::string& where)
    : from_(from),
      to_(to),
      from_size_(picture),
      view_(lippmann::view_size(from, picture, where)),
      to_size_(picture_size(to, view_)) {}

Image Arrangement::apply(const Image& picture) const {
  Image arranged(to_size_.x, to_size_.y, picture.channels);
  const std::ptrdiff_t channels = picture.channels;
  for (int view = 0; view < from_.grid.count(); ++view) {
    const ViewPlace source = place_of_view(from_, view_, from_size_, view), target = place_of_view(to_, view_, to_size_, view);
    for (int y = 0; y < view_.y; ++y) {
      const float* in = picture.data.data() + channels * (source.first + y * source.down);
      float* out = arranged.data.data() + channels * (target.first + y * target.down);
      for (int x = 0; x < view_.x; ++x, in += channels * source.across, out += channels * target.across)
        std::copy_n(in, channels, out);
    }
  }
  return arranged;
}

}  // namespace lippmann
