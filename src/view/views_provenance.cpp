#include "view/views_provenance.hpp"

#include <algorithm>

#include "core/text_pattern.hpp"
#include "layout/rendered.hpp"
#include "layout/view_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool has_size(const std::optional<Image>& layer, Vec2i size) { return layer && Vec2i(layer->width, layer->height) == size; }

std::optional<Image> of_folder(const fs::path& folder, const LightField& field) {
  static const TextPattern name("view_([0-9]{1,6})\\.[^.]+");
  Image stack(stack_size(field).x, stack_size(field).y, 1);
  auto to = stack.data.begin();
  for (const NumberedFile& view : numbered_files(folder, name, "view_000.png, view_001.png, ...")) {
    const std::optional<Image> layer = rendered_provenance(view.path);
    if (!has_size(layer, field.view_size) || stack.data.end() - to < std::ssize(layer->data)) return std::nullopt;
    to = std::copy(layer->data.begin(), layer->data.end(), to);
  }
  return stack;
}

std::optional<Image> of_picture(const fs::path& picture, const LightField& field) {
  const LayoutKind kind = field.tiles ? LayoutKind::kQuilt : LayoutKind::kIntegral;
  const ViewLayout layout{kind, field.grid, field.tiles.value_or(ViewGrid{})};
  const std::optional<Image> layer = rendered_provenance(picture);
  if (!has_size(layer, picture_size(layout, field.view_size))) return std::nullopt;
  Image stack(stack_size(field).x, stack_size(field).y, 1);
  move_pixels(*layer, pixels_of_views(layout, field.view_size, Vec2i(layer->width, layer->height)), stack, {});
  return stack;
}

}  // namespace

std::optional<Image> views_provenance(const fs::path& path, const LightField& field) {
  return fs::is_directory(path) ? of_folder(path, field) : of_picture(path, field);
}

}  // namespace lippmann
