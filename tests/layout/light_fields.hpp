// Light fields whose samples all differ, as far as 8-bit or 16-bit codes allow.
#pragma once

#include <cstdint>

#include "lippmann/layout/light_field.hpp"

namespace lippmann::test {

inline LightField numbered_field(ViewGrid grid, Vec2i view_size, bool words = false) {
  LightField field;
  field.grid = grid, field.view_size = view_size;
  field.aspect = static_cast<double>(view_size.x) / view_size.y;
  const Vec2i size = stack_size(field);
  const int samples = 3 * size.x * size.y;
  if (words) {
    Image16 image{size.x, size.y, {}};
    for (int i = 0; i < samples; ++i) image.rgb.push_back(static_cast<std::uint16_t>(i * 257 + 13));
    field.stack = image;
  } else {
    Image8 image{size.x, size.y, {}};
    for (int i = 0; i < samples; ++i) image.rgb.push_back(static_cast<unsigned char>(i * 7 + i / 256));
    field.stack = image;
  }
  return field;
}

inline bool same_samples(const Picture& a, const Picture& b) {
  if (a.index() != b.index() || size_of(a) != size_of(b)) return false;
  if (const auto* bytes = std::get_if<Image8>(&a)) return bytes->rgb == std::get<Image8>(b).rgb;
  if (const auto* words = std::get_if<Image16>(&a)) return words->rgb == std::get<Image16>(b).rgb;
  return std::get<Image>(a).data == std::get<Image>(b).data;
}

}  // namespace lippmann::test
