#include "image/draw.hpp"

#include <stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kQuadBytes = 64, kCornerBytes = 16;

/// Replaces characters that the font lacks by '?'. Keeps line breaks.
std::string font_text(std::string_view text) {
  std::string known(text);
  std::replace_if(
      known.begin(), known.end(), [](char c) { return c != '\n' && (c < ' ' || c > '~'); }, '?');
  return known;
}

std::vector<PixelBox> text_boxes(std::string_view text) {
  constexpr std::size_t kQuadsPerLetter = 32;
  std::string known = font_text(text);
  std::vector<float> vertices(kQuadsPerLetter * (known.size() + 1) * kQuadBytes / sizeof(float));
  const int quads = stb_easy_font_print(0.0f, 0.0f, known.data(), nullptr, vertices.data(),
                                        static_cast<int>(vertices.size() * sizeof(float)));
  std::vector<PixelBox> boxes;
  constexpr std::size_t kQuad = kQuadBytes / sizeof(float), kOpposite = 2 * kCornerBytes / sizeof(float);
  for (std::size_t at = 0; at < static_cast<std::size_t>(quads) * kQuad; at += kQuad)
    boxes.push_back({Vec2i(vertices[at], vertices[at + 1]), Vec2i(vertices[at + kOpposite], vertices[at + kOpposite + 1])});
  return boxes;
}

template <class Sample>
Sample sample_of_code(unsigned char code) {
  if constexpr (std::is_floating_point_v<Sample>)
    return static_cast<Sample>(linear_from_srgb(code / 255.0));
  else
    return static_cast<Sample>(code * (sizeof(Sample) == 1 ? 1 : 257));
}

template <class Sample>
void fill_samples(std::vector<Sample>& samples, int width, const PixelBox& box, const Rgb8& colour) {
  const std::array<Sample, 3> pixel{sample_of_code<Sample>(colour[0]), sample_of_code<Sample>(colour[1]),
                                    sample_of_code<Sample>(colour[2])};
  for (int y = box.from.y; y < box.to.y; ++y) {
    auto out = samples.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + box.from.x);
    for (int x = box.from.x; x < box.to.x; ++x) out = std::copy(pixel.begin(), pixel.end(), out);
  }
}

}  // namespace

void fill_box(Picture& picture, const PixelBox& box, const Rgb8& colour) {
  std::visit(
      [&](auto& image) {
        const Vec2i size(image.width, image.height);
        const PixelBox inside{glm::clamp(box.from, Vec2i(0), size), glm::clamp(box.to, Vec2i(0), size)};
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(image)>, Image>)
          fill_samples(image.data, image.width, inside, colour);
        else
          fill_samples(image.rgb, image.width, inside, colour);
      },
      picture);
}

Vec2i text_units(std::string_view text) {
  std::string known = font_text(text);
  return {stb_easy_font_width(known.data()), stb_easy_font_height(known.data())};
}

void draw_text(Picture& picture, Vec2i corner, int scale, std::string_view text, const Rgb8& colour) {
  for (const PixelBox& box : text_boxes(text)) fill_box(picture, {corner + scale * box.from, corner + scale * box.to}, colour);
}

}  // namespace lippmann
