#include "lippmann/layout/light_field.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "layout/picture_samples.hpp"

namespace lippmann {
namespace {

template <class T>
void move_samples(const T& from, const std::vector<std::uint32_t>& from_pixel, T& to,
                  const std::vector<std::uint32_t>& to_pixel, std::ptrdiff_t channels) {
  const std::size_t count = std::max(from_pixel.size(), to_pixel.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t s = from_pixel.empty() ? i : from_pixel[i], t = to_pixel.empty() ? i : to_pixel[i];
    std::copy_n(samples_of(from).begin() + channels * static_cast<std::ptrdiff_t>(s), channels,
                samples_of(to).begin() + channels * static_cast<std::ptrdiff_t>(t));
  }
}

std::vector<std::uint32_t> pixels_of(const LightField& field, int view) {
  const auto size = static_cast<std::uint32_t>(field.view_size.x) * static_cast<std::uint32_t>(field.view_size.y);
  std::vector<std::uint32_t> pixels(size);
  for (std::uint32_t i = 0; i < size; ++i) pixels[i] = static_cast<std::uint32_t>(view) * size + i;
  return pixels;
}

}  // namespace

double pixel_aspect(const LightField& field) {
  constexpr double kRounding = 0.01;
  const double aspect = field.aspect * field.view_size.y / field.view_size.x;
  return std::abs(aspect - 1.0) < kRounding ? 1.0 : aspect;
}

Vec2i size_of(const Picture& picture) {
  return std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
}

Picture blank(const Picture& like, Vec2i size) {
  return std::visit(
      [&](const auto& image) {
        auto copy = std::remove_cvref_t<decltype(image)>();
        copy.width = size.x, copy.height = size.y;
        samples_of(copy).resize(3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        return Picture(std::move(copy));
      },
      like);
}

void move_pixels(const Picture& from, const std::vector<std::uint32_t>& from_pixel, Picture& to,
                 const std::vector<std::uint32_t>& to_pixel) {
  assert(from.index() == to.index());
  std::visit(
      [&](const auto& source) {
        move_samples(source, from_pixel, std::get<std::remove_cvref_t<decltype(source)>>(to), to_pixel, 3);
      },
      from);
}

void move_pixels(const Image& from, const std::vector<std::uint32_t>& from_pixel, Image& to,
                 const std::vector<std::uint32_t>& to_pixel) {
  assert(from.channels == to.channels);
  move_samples(from, from_pixel, to, to_pixel, from.channels);
}

Picture view_of(const LightField& field, int view) {
  Picture picture = blank(field.stack, field.view_size);
  move_pixels(field.stack, pixels_of(field, view), picture, {});
  return picture;
}

Image depth_of(const LightField& field, int view) {
  Image depth(field.view_size.x, field.view_size.y, 1);
  move_pixels(*field.depth, pixels_of(field, view), depth, {});
  return depth;
}

Image alpha_of(const LightField& field, int view) {
  Image alpha(field.view_size.x, field.view_size.y, 1);
  move_pixels(*field.alpha, pixels_of(field, view), alpha, {});
  return alpha;
}

void set_view(LightField& field, int view, const Picture& picture) {
  move_pixels(picture, {}, field.stack, pixels_of(field, view));
}

void set_depth(LightField& field, int view, const Image& depth) {
  move_pixels(depth, {}, *field.depth, pixels_of(field, view));
}

void set_alpha(LightField& field, int view, const Image& alpha) {
  if (!field.alpha) {
    field.alpha = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    std::ranges::fill(field.alpha->data, 1.0f);
  }
  move_pixels(alpha, {}, *field.alpha, pixels_of(field, view));
}

}  // namespace lippmann
