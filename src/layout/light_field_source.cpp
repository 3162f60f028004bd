#include "layout/light_field_source.hpp"

#include <array>

#include "core/folder_entries.hpp"
#include "core/text_pattern.hpp"
#include "layout/frame_names.hpp"
#include "layout/rgbd_name.hpp"
#include "layout/rgbd_side_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/open_light_field.hpp"
#include "lippmann/layout/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// The format whose files a folder of views holds, by the name of any of them; none: of no format.
std::optional<std::string> format_of_folder(const fs::path& folder) {
  struct Kind {
    std::string_view format;
    TextPattern file;
  };
  static const std::array<Kind, 5> kinds{
      Kind{"miv", TextPattern("cameras\\.json")}, Kind{"hci", TextPattern("input_Cam[0-9]{1,6}\\.[^.]+")},
      Kind{"stanford", TextPattern("out_[0-9]{1,5}_[0-9]{1,5}(?:_.*)?\\.[^.]+")},
      Kind{"jpeg-pleno", TextPattern("[0-9]{1,4}_[0-9]{1,4}\\.ppm")}, Kind{"views", TextPattern("view_[0-9]{1,6}\\.[^.]+")}};
  std::array<bool, kinds.size()> found{};
  for (const fs::directory_entry& entry : entries_of(folder))
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i].file.match(entry.path().filename().string())) found[i] = true;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (found[i]) return std::string(kinds[i].format);
  return std::nullopt;
}

std::string format_of(const fs::path& path, const LightFieldSource& source) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return format_of_folder(path).value_or("views");
  if (parse_quilt_name(path)) return "quilt";
  if (parse_stereo_name(path)) return "stereo";
  if (has_rgbd_name(path) || read_rgbd_side_file(path)) return "rgbd";
  if (source.rendering && !source.rendering->layout.empty()) return source.rendering->layout;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
  if (source.rendering && !source.rendered)
    throw usage_error("from",
                      path.string() +
                          " was rendered for lenses that do not have a whole number of pixels: what is below them "
                          "makes no views",
                      "what was rendered with `layout` views or quilt");
  if (!source.rendered) throw usage_error("from", "nothing says what " + path.string() + " is", "the name of a format");
  switch (source.rendered->film.kind) {
    case LayoutKind::kQuilt:
      return "quilt";
    case LayoutKind::kStack:
      throw usage_error("from", path.string() + " is a single view", "pictures of several");
    default:
      return "integral";
  }
}

}  // namespace

LightFieldSource light_field_source(const fs::path& path, const std::string& from, const FormatOptions& options) {
  LightFieldSource source{nullptr, options};
  const bool may_be_rendered = from.empty() || from == "integral" || from == "quilt" || from == "views" || from == "stereo";
  if (may_be_rendered) source.rendering = rendering_of(path);
  if (source.rendering)
    source.rendered = rendered_views(with_parallax(source.rendering->optics, source.rendering->depth_scale));
  source.format = &find_format(from.empty() ? format_of(path, source) : from, "from");
  if ((source.format->is_folder && source.format->name != "views") || source.format->name == "rgbd")
    source.rendering.reset(), source.rendered.reset();
  if (source.rendering && !source.rendering->has_depth_layer) source.options.with_depth = false;
  if (!source.rendered) return source;
  const ViewLayout& film = source.rendered->film;
  if (!source.options.views) source.options.views = film.grid;
  const bool named_by_quilt = parse_quilt_name(path).has_value();
  if (!source.options.tiles && film.kind == LayoutKind::kQuilt && !named_by_quilt) source.options.tiles = film.tiles;
  return source;
}

bool is_light_field_folder(const fs::path& folder) { return format_of_folder(folder).has_value(); }

namespace {

/// Whether the views have the pixels that their report speaks of; of a picture of rows, half of them are there.
bool has_all_pixels(const LightFieldSource& source, const LightField& field, const fs::path& path) {
  if (source.format->name != "stereo") return true;
  return view_size(source.rendered->film, film_size(source.rendering->optics), path.string()) == field.view_size;
}

}  // namespace

std::vector<fs::path> light_field_frames(const fs::path& folder, const std::string& from) {
  if (!from.empty()) return find_format(from, "from").is_folder ? frame_folders_in(folder) : frame_pictures_in(folder);
  std::vector<fs::path> pictures = frame_pictures_in(folder);
  return pictures.empty() ? frame_folders_in(folder) : pictures;
}

OpenedLightField open_light_field(const fs::path& path, const std::string& from, const FormatOptions& options) {
  const LightFieldSource source = light_field_source(path, from, options);
  OpenedLightField opened{source.format->read(path, source.options)};
  opened.format = source.format->name;
  if (!source.rendered || source.rendered->film.grid != opened.field.grid) return opened;
  if (!has_all_pixels(source, opened.field, path)) return opened;
  opened.field.cameras = source.rendered->cameras;
  opened.optics = source.rendering->optics;
  return opened;
}

std::vector<fs::path> light_fields_in(const fs::path& path, const std::string& from) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
  if (!fs::is_directory(path, ignored)) return {path};
  std::vector<fs::path> frames = light_field_frames(path, from);
  if (!frames.empty()) return frames;
  if (from.empty() && !is_light_field_folder(path))
    throw Error(path.string(), "contains no frames, and no views",
                "frame_0000.png, frame_0001.png, ..., or a folder of views that `lippmann convert` reads");
  return {path};
}

}  // namespace lippmann
