#include "lippmann/layout/film_views.hpp"

#include <fmt/core.h>

#include <optional>

#include "image/require_samples.hpp"
#include "layout/cameras.hpp"
#include "layout/sub_pixels.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Throws Error unless the image has the film's size and `channels` channels; 0: any number.
void require_size(const Image& image, Vec2i film, int channels, const char* what) {
  require_samples(image, what);
  if (channels > 0) require_channels(image, channels, what);
  if (image.width == film.x && image.height == film.y) return;
  throw Error(what, fmt::format("has {}x{} pixels", image.width, image.height),
              fmt::format("{}x{}, the size of the panel", film.x, film.y));
}

RenderedViews required_views(const Optics& optics) {
  if (std::optional<RenderedViews> rendered = rendered_views(optics)) return *rendered;
  throw Error("optics", "lenses without a whole number of pixels have no views",
              "a whole number of pixels below every lens, without slant or hexagonal packing");
}

}  // namespace

LightField light_field_of(const Image& film, const Optics& optics, const Image* depth) {
  const Vec2i size = film_size(optics);
  require_size(film, size, 3, "film");
  if (depth) require_size(*depth, size, 1, "depth");
  const RenderedViews rendered = required_views(optics);
  const ViewLayout& layout = rendered.film;
  LightField field;
  field.grid = layout.grid;
  field.view_size = view_size(layout, size, "film");
  const Vec2f window = window_size_mm(optics);
  field.aspect = static_cast<double>(window.x) / window.y;
  if (layout.kind == LayoutKind::kQuilt) field.tiles = layout.tiles;
  field.cameras = rendered.cameras;
  const std::vector<std::uint32_t> pixels = pixels_of_views(layout, field.view_size, size);
  field.stack = blank(Picture(film), stack_size(field));
  move_pixels(Picture(film), pixels, field.stack, {});
  if (!depth) return field;
  field.depth = Image(stack_size(field).x, stack_size(field).y, 1);
  move_pixels(*depth, pixels, *field.depth, {});
  return field;
}

Image views_of_layer(const Image& layer, const Optics& optics) {
  const Vec2i size = film_size(optics);
  require_size(layer, size, 0, "layer");
  const ViewLayout film = required_views(optics).film;
  const Vec2i view = view_size(film, size, "layer");
  Image stack(view.x, view.y * film.grid.count(), layer.channels);
  move_pixels(layer, pixels_of_views(film, view, size), stack, {});
  return stack;
}

Image picture_of_film(const Image& film, const Optics& optics) {
  require_size(film, film_size(optics), 3, "film");
  return sub_pixels_per_pixel(optics) > 1 ? join_sub_pixels(film) : film;
}

Image picture_of_layer(const Image& layer, const Optics& optics) {
  require_size(layer, film_size(optics), 0, "layer");
  return sub_pixels_per_pixel(optics) > 1 ? middle_sub_pixels(layer) : layer;
}

}  // namespace lippmann
