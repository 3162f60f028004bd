#include "layout/sub_pixels.hpp"

namespace lippmann {
namespace {

/// Channel c of a pixel is taken from the pixel's sub-pixel first + c * step.
Image pick(const Image& film, int first, int step) {
  Image picture(film.width / 3, film.height, film.channels);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < film.channels; ++c) picture.pixel(x, y)[c] = film.pixel(3 * x + first + c * step, y)[c];
  return picture;
}

}  // namespace

Image join_sub_pixels(const Image& film) { return pick(film, 0, 1); }
Image middle_sub_pixels(const Image& film) { return pick(film, 1, 0); }

}  // namespace lippmann
