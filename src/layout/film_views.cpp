#include "lippmann/layout/film_views.hpp"

#include <fmt/core.h>

#include <optional>

#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

void require_size(const Image& image, Vec2i film, const char* what) {
  if (image.width == film.x && image.height == film.y) return;
  throw Error(what, fmt::format("has {}x{} pixels", image.width, image.height),
              fmt::format("{}x{}, those of the panel", film.x, film.y));
}

}  // namespace

LightField light_field_of(const Image& film, const Optics& optics, const Image* depth) {
  const Vec2i size = film_size(optics);
  require_size(film, size, "film");
  if (depth) require_size(*depth, size, "depth");
  const std::optional<RenderedViews> rendered = rendered_views(optics);
  if (!rendered)
    throw Error("optics", "its lenses do not have a whole number of pixels, and make no views",
                "views, or lenses with a whole number of pixels below each, neither slanted nor hexagonal");
  const ViewLayout& layout = rendered->film;
  LightField field;
  field.grid = layout.grid;
  field.view_size = view_size(layout, size, "film");
  const Vec2f window = window_size_mm(optics);
  field.aspect = static_cast<double>(window.x) / window.y;
  if (layout.kind == LayoutKind::kQuilt) field.tiles = layout.tiles;
  field.cameras = rendered->cameras;
  const std::vector<std::uint32_t> pixels = pixels_of_views(layout, field.view_size, size);
  field.stack = blank(Picture(film), stack_size(field));
  move_pixels(Picture(film), pixels, field.stack, {});
  if (!depth) return field;
  field.depth = Image(stack_size(field).x, stack_size(field).y, 1);
  move_pixels(*depth, pixels, *field.depth, {});
  return field;
}

}  // namespace lippmann
