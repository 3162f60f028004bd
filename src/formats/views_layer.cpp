#include "formats/views_layer.hpp"

#include <algorithm>

#include "core/text_pattern.hpp"
#include "formats/rendered.hpp"
#include "formats/view_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// A function that reads one layer, such as rendered_motion().
using LayerReader = std::optional<Image> (*)(const fs::path& picture);

bool has_size(const std::optional<Image>& layer, Vec2i size) { return layer && Vec2i(layer->width, layer->height) == size; }

std::optional<Image> layer_of_folder(const fs::path& folder, const LightField& field, LayerReader read) {
  static const TextPattern name("view_([0-9]{1,6})\\.[^.]+");
  std::optional<Image> stack;
  std::ptrdiff_t filled = 0;
  for (const NumberedFile& view : find_numbered_files(folder, name, "view_000.png, view_001.png, ...")) {
    const std::optional<Image> layer = read(view.path);
    if (!has_size(layer, field.view_size)) return std::nullopt;
    if (!stack) stack = Image(stack_size(field).x, stack_size(field).y, layer->channels);
    if (std::ssize(stack->data) - filled < std::ssize(layer->data)) return std::nullopt;
    std::copy(layer->data.begin(), layer->data.end(), stack->data.begin() + filled);
    filled += std::ssize(layer->data);
  }
  return stack;
}

std::optional<Image> layer_of_picture(const fs::path& picture, const LightField& field, LayerReader read) {
  const LayoutKind kind = field.tiles ? LayoutKind::kQuilt : LayoutKind::kIntegral;
  const ViewLayout layout{kind, field.grid, field.tiles.value_or(ViewGrid{})};
  const std::optional<Image> layer = read(picture);
  if (!has_size(layer, picture_size(layout, field.view_size))) return std::nullopt;
  Image stack(stack_size(field).x, stack_size(field).y, layer->channels);
  move_pixels(*layer, pixels_of_views(layout, field.view_size, Vec2i(layer->width, layer->height)), stack, {});
  return stack;
}

std::optional<Image> views_layer(const fs::path& path, const LightField& field, LayerReader read) {
  return fs::is_directory(path) ? layer_of_folder(path, field, read) : layer_of_picture(path, field, read);
}

}  // namespace

std::optional<Image> views_provenance(const fs::path& path, const LightField& field) {
  return views_layer(path, field, rendered_provenance);
}

std::optional<Image> views_motion(const fs::path& path, const LightField& field) {
  return views_layer(path, field, rendered_motion);
}

}  // namespace lippmann
