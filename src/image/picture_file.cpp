#include "lippmann/image/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "image/require_samples.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

Image16 to_image16(const Image& image) {
  Image16 codes{image.width, image.height, {}};
  codes.rgb.reserve(image.data.size());
  for (const float value : image.data) codes.rgb.push_back(static_cast<std::uint16_t>(value * 65535.0f + 0.5f));
  return codes;
}

template <class Code>
Image linear_from_codes(int width, int height, const std::vector<Code>& codes) {
  constexpr std::size_t kCodes = std::size_t{1} << (8 * sizeof(Code));
  std::vector<float> value(kCodes);
  for (std::size_t i = 0; i < kCodes; ++i)
    value[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / (kCodes - 1.0)));
  Image image(width, height, 3);
  std::transform(codes.begin(), codes.end(), image.data.begin(), [&](Code code) { return value[code]; });
  return image;
}

}  // namespace

Picture read_picture(const std::filesystem::path& path, const std::function<void(std::string_view)>& warn) {
  switch (sample_kind(path)) {
    case SampleKind::kByte:
      return read_image8(path, warn);
    case SampleKind::kWord:
      return to_image16(read_rgb(path, warn));
    case SampleKind::kFloat:
      break;
  }
  return read_rgb(path, warn);
}

void check_picture_ending(const std::filesystem::path& path, const Picture& picture) {
  const char* ending = std::holds_alternative<Image>(picture) ? ".exr" : ".png";
  if (path.extension() != ending)
    throw Error(path.string(), "this format cannot store the samples unchanged",
                std::string(ending) + (std::holds_alternative<Image>(picture) ? " for float samples" : " for 8 or 16 bits"));
}

void write_picture(const std::filesystem::path& path, const Picture& picture, double dots_per_inch) {
  check_picture_ending(path, picture);
  require_samples(picture, path.string());
  if (const auto* light = std::get_if<Image>(&picture)) require_channels(*light, 3, path.string());
  PngOptions options;
  options.dots_per_inch = dots_per_inch;
  if (const auto* bytes = std::get_if<Image8>(&picture)) return write_png(path, *bytes, options);
  if (const auto* words = std::get_if<Image16>(&picture)) return write_png(path, *words, options);
  const std::array<ExrLayer, 1> layers{film_layer(std::get<Image>(picture), ExrSample::kFloat)};
  write_exr(path, layers);
}

Image to_linear(Picture picture) {
  if (const auto* bytes = std::get_if<Image8>(&picture)) return linear_from_codes(bytes->width, bytes->height, bytes->rgb);
  if (const auto* words = std::get_if<Image16>(&picture)) return linear_from_codes(words->width, words->height, words->rgb);
  Image image = std::get<Image>(std::move(picture));
  for (float& value : image.data)
    if (!std::isfinite(value)) value = 0.0f;
  return image;
}

Picture with_samples_like(const Picture& like, Image linear) {
  if (std::holds_alternative<Image8>(like)) return to_codes(linear, Encoding::kSrgb);
  if (std::holds_alternative<Image16>(like)) return to_codes16(linear, Encoding::kSrgb);
  return linear;
}

}  // namespace lippmann
