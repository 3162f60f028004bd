#include "formats/packed_views.hpp"

#include <fmt/format.h>

#include "formats/picture_alpha.hpp"
#include "formats/rendered.hpp"
#include "image/read_image.hpp"

namespace lippmann {
namespace fs = std::filesystem;
namespace {

void warn_about_padding(const fs::path& path, Vec2i size, Vec2i used, const std::function<void(std::string_view)>& warn) {
  if (size == used || !warn) return;
  warn(fmt::format(
      "{}: its {}x{} pixels cannot be divided evenly into its tiles: {} columns at the right and {} rows at the top "
      "are left out",
      path.string(), size.x, size.y, size.x - used.x, size.y - used.y));
}

}  // namespace

LightField read_packed(const fs::path& path, const ViewLayout& layout, bool with_depth,
                       const std::function<void(std::string_view)>& warn) {
  const Picture picture = read_picture(path, warn);
  const Vec2i size = size_of(picture);
  LightField field;
  field.grid = layout.grid;
  field.view_size = view_size(layout, size, path.string());
  warn_about_padding(path, size, picture_size(layout, field.view_size), warn);
  field.aspect = static_cast<double>(size.x) / size.y;
  field.stack = blank(picture, stack_size(field));
  const std::vector<std::uint32_t> pixels = pixels_of_views(layout, field.view_size, size);
  move_pixels(picture, pixels, field.stack, {});
  if (const std::optional<Image> alpha = read_alpha(path)) {
    field.alpha = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    move_pixels(*alpha, pixels, *field.alpha, {});
  }
  if (!with_depth) return field;
  if (const std::optional<Image> depth = rendered_depth(path); depth && Vec2i(depth->width, depth->height) == size) {
    field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    move_pixels(*depth, pixels, *field.depth, {});
  }
  return field;
}

std::vector<fs::path> write_packed(const LightField& field, const ViewLayout& layout, const fs::path& path) {
  const Vec2i size = picture_size(layout, field.view_size);
  const std::vector<std::uint32_t> pixels = pixels_of_views(layout, field.view_size, size);
  Picture picture = blank(field.stack, size);
  move_pixels(field.stack, {}, picture, pixels);
  std::optional<Image> alpha;
  if (field.alpha) {
    alpha = Image(size.x, size.y, 1);
    move_pixels(*field.alpha, {}, *alpha, pixels);
  }
  write_picture(path, std::move(picture), alpha ? &*alpha : nullptr);
  return {path};
}

}  // namespace lippmann
