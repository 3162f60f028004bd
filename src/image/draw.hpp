// Draws boxes and ASCII text into images, for labels of test sheets and marks around prints. Colours are 8-bit sRGB codes,
// converted to the picture's sample type. Text is measured in units of `scale` pixels, so that letters have sharp edges.
#pragma once

#include <array>
#include <string_view>

#include "lippmann/core/math.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

using Rgb8 = std::array<unsigned char, 3>;
inline constexpr Rgb8 kBlackRgb{0, 0, 0}, kWhiteRgb{255, 255, 255};

/// `to` is excluded.
struct PixelBox {
  Vec2i from{0, 0}, to{0, 0};

  Vec2i size() const { return to - from; }
};

inline constexpr int kTextCapital = 7, kTextLine = 12;  ///< heights of a capital letter and of a line of text, in units

void fill_box(Picture& picture, const PixelBox& box, const Rgb8& colour);

/// Returns the width of the longest line and the height of all lines, in units.
Vec2i text_units(std::string_view text);

void draw_text(Picture& picture, Vec2i corner, int scale, std::string_view text, const Rgb8& colour = kBlackRgb);

}  // namespace lippmann
