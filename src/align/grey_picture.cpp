#include "align/grey_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "image/resample.hpp"

namespace lippmann {
namespace {

template <class Sample>
Image mean_of_channels(int width, int height, const std::vector<Sample>& rgb) {
  constexpr float kScale = 1.0f / (3.0f * std::numeric_limits<Sample>::max());
  Image grey(width, height, 1);
  for (std::size_t i = 0; i < grey.data.size(); ++i)
    grey.data[i] = kScale * static_cast<float>(rgb[3 * i] + rgb[3 * i + 1] + rgb[3 * i + 2]);
  return grey;
}

Image grey_codes(const Picture& picture) {
  if (const auto* codes = std::get_if<Image8>(&picture)) return mean_of_channels(codes->width, codes->height, codes->rgb);
  if (const auto* codes = std::get_if<Image16>(&picture)) return mean_of_channels(codes->width, codes->height, codes->rgb);
  return grey_codes(with_samples_like(Image16{}, std::get<Image>(picture)));
}

}  // namespace

GreyPicture grey_of(const Picture& picture, int longest) {
  Image grey = grey_codes(picture);
  const double share = static_cast<double>(longest) / std::max(grey.width, grey.height);
  if (share < 1.0) grey = resampled(grey, glm::max(Vec2i(glm::round(Vec2d(grey.width, grey.height) * share)), Vec2i(1)));
  GreyPicture result{grey.width, grey.height, {}};
  result.codes.reserve(grey.data.size());
  for (const float value : grey.data)
    result.codes.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f));
  return result;
}

}  // namespace lippmann
