// Based on: H. S. Malvar, L. He, R. Cutler, "High-quality linear interpolation for demosaicing of Bayer-patterned color
// images", ICASSP 2004, figure 2. Each missing colour is the mean of the neighbours that measure this colour, corrected by the
// second derivative of the colour that the pixel measures.
//
// We deviate: the image is mirrored at its edges, which continues the Bayer pattern.
#include "image/demosaic.hpp"

#include <algorithm>

namespace lippmann {
namespace {

class Mosaic {
 public:
  explicit Mosaic(const Image& image) : image_(image) {}

  float at(int x, int y) const { return *image_.pixel(mirrored(x, image_.width), mirrored(y, image_.height)); }
  float sides(int x, int y, int step) const { return at(x - step, y) + at(x + step, y); }
  float ends(int x, int y, int step) const { return at(x, y - step) + at(x, y + step); }
  float corners(int x, int y) const { return sides(x, y - 1, 1) + sides(x, y + 1, 1); }

  float green_at_color(int x, int y) const {
    return (4.0f * at(x, y) + 2.0f * (sides(x, y, 1) + ends(x, y, 1)) - sides(x, y, 2) - ends(x, y, 2)) / 8.0f;
  }
  /// Computes the colour that the left and right neighbours of a green pixel measure.
  float color_beside(int x, int y) const {
    return (5.0f * at(x, y) + 4.0f * sides(x, y, 1) - corners(x, y) - sides(x, y, 2) + 0.5f * ends(x, y, 2)) / 8.0f;
  }
  /// Computes the colour that the upper and lower neighbours of a green pixel measure.
  float color_above(int x, int y) const {
    return (5.0f * at(x, y) + 4.0f * ends(x, y, 1) - corners(x, y) - ends(x, y, 2) + 0.5f * sides(x, y, 2)) / 8.0f;
  }
  float other_color(int x, int y) const {
    return (6.0f * at(x, y) + 2.0f * corners(x, y) - 1.5f * (sides(x, y, 2) + ends(x, y, 2))) / 8.0f;
  }

 private:
  static int mirrored(int i, int count) { return i < 0 ? -i : i >= count ? 2 * (count - 1) - i : i; }
  const Image& image_;
};

}  // namespace

Image demosaic(const Image& mosaic, Vec2i red) {
  const Mosaic seen(mosaic);
  Image colors(mosaic.width, mosaic.height, 3);
  for (int y = 0; y < mosaic.height; ++y)
    for (int x = 0; x < mosaic.width; ++x) {
      float* color = colors.pixel(x, y);
      const bool red_column = (x & 1) == red.x, red_row = (y & 1) == red.y;
      if (red_column == red_row) {
        const int own = red_row ? 0 : 2;
        color[own] = seen.at(x, y), color[1] = seen.green_at_color(x, y), color[2 - own] = seen.other_color(x, y);
      } else {
        const int beside = red_row ? 0 : 2;
        color[beside] = seen.color_beside(x, y), color[1] = seen.at(x, y), color[2 - beside] = seen.color_above(x, y);
      }
      for (const int c : {0, 1, 2}) color[c] = std::max(0.0f, color[c]);
    }
  return colors;
}

}  // namespace lippmann
