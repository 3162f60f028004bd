#include "layout/packed_views.hpp"

namespace lippmann {
namespace fs = std::filesystem;

LightField read_packed(const fs::path& path, const ViewLayout& layout) {
  const Picture picture = read_picture(path);
  const Vec2i size = size_of(picture);
  LightField field;
  field.grid = layout.grid;
  field.view_size = view_size(layout, size, path.string());
  field.aspect = static_cast<double>(size.x) / size.y;
  field.stack = blank(picture, stack_size(field));
  move_pixels(picture, pixels_of_views(layout, field.view_size, size), field.stack, {});
  return field;
}

Image unpack_layer(const Image& layer, const ViewLayout& layout, Vec2i view_size) {
  Image stack(view_size.x, view_size.y * layout.grid.count(), layer.channels);
  move_pixels(layer, pixels_of_views(layout, view_size, {layer.width, layer.height}), stack, {});
  return stack;
}

std::vector<fs::path> write_packed(const LightField& field, const ViewLayout& layout, const fs::path& path) {
  const Vec2i size = picture_size(layout, field.view_size);
  Picture picture = blank(field.stack, size);
  move_pixels(field.stack, {}, picture, pixels_of_views(layout, field.view_size, size));
  write_picture(path, picture);
  return {path};
}

}  // namespace lippmann
