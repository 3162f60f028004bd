#include "formats/light_field_source.hpp"

#include <fmt/format.h>

#include <array>

#include "core/folder_entries.hpp"
#include "core/regular_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/eslf_side_file.hpp"
#include "formats/frame_names.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/lytro_raw.hpp"
#include "formats/picture_folder.hpp"
#include "formats/quad_name.hpp"
#include "formats/quilt_side_file.hpp"
#include "formats/rgbd_name.hpp"
#include "formats/rgbd_side_file.hpp"
#include "formats/stated_cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/formats/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Returns the format whose file names the folder contains; none if there is no such format.
std::optional<std::string> format_of_folder(const fs::path& folder) {
  struct Kind {
    std::string_view format;
    TextPattern file;
  };
  const auto kind = [](std::string_view format, const char* file) {
    return Kind{format, TextPattern(file, TextPattern::Letters::kEitherCase)};
  };
  static const std::array<Kind, 10> kinds{
      kind("nerf", "transforms(?:_train)?\\.json"),
      kind("llff", "poses_bounds\\.npy"),
      kind("colmap", "sparse"),
      kind("miv", "cameras\\.json"),
      kind("cvkit", ".{1,200}_param\\.txt"),
      kind("hci", "input_Cam[0-9]{1,6}\\.[^.]+"),
      kind("stanford", "out_[0-9]{1,5}_[0-9]{1,5}(?:_.*)?\\.[^.]+"),
      kind("jpeg-pleno", "[0-9]{1,4}_[0-9]{1,4}\\.(?:ppm|png|tiff?|bmp|jpe?g|webp|exr)"),
      kind("lytro", "(?:sai|lf)_[0-9]{1,4}_[0-9]{1,4}\\.(?:ppm|png|tiff?|bmp|jpe?g|webp|exr)"),
      kind("views", "view_[0-9]{1,6}\\.[^.]+")};
  std::array<bool, kinds.size()> found{};
  for (const fs::directory_entry& entry : entries_of(folder))
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i].file.match(entry.path().filename().string())) found[i] = true;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (found[i]) return std::string(kinds[i].format);
  return std::nullopt;
}

bool has_hdf5_name(const fs::path& file) {
  static const TextPattern hdf5(".*\\.(?:h5|hdf5)", TextPattern::Letters::kEitherCase);
  return hdf5.match(file.filename().string()).has_value();
}

bool has_lytro_name(const fs::path& file) {
  static const TextPattern lytro(".*\\.(?:lfp|lfr)", TextPattern::Letters::kEitherCase);
  return lytro.match(file.filename().string()).has_value();
}

/// Returns all pictures of a folder or, if `from` is empty, those whose names or side files imply a format.
std::vector<fs::path> described_pictures_in(const fs::path& folder, const std::string& from) {
  std::vector<fs::path> pictures;
  for (const fs::directory_entry& entry : entries_of(folder))
    if (entry.is_regular_file() && is_picture_name(entry.path()))
      if (!from.empty() || format_by_name(entry.path())) pictures.push_back(entry.path());
  return pictures;
}

/// Returns whether the picture was rendered for microlenses whose elemental images are not a whole number of pixels wide.
bool has_fractional_lenses(const LightFieldSource& source) {
  return source.rendering && !source.rendered && elemental_images(source.rendering->optics);
}

std::string format_of(const fs::path& path, const LightFieldSource& source) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return format_of_folder(path).value_or("views");
  if (const std::optional<std::string> stated = format_by_name(path)) return *stated;
  if (has_fractional_lenses(source) && (source.rendering->layout.empty() || source.rendering->layout == "integral"))
    return "plenoptic";
  if (source.rendering && !source.rendering->layout.empty()) return source.rendering->layout;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
  if (source.rendering && !source.rendered)
    throw usage_error("from", path.string() + " was rendered for lenses without a whole number of pixels, so it has no views",
                      "a render with `layout` views or quilt");
  if (!source.rendered) throw unknown_format(path);
  switch (source.rendered->film.kind) {
    case LayoutKind::kQuilt:
      return "quilt";
    case LayoutKind::kStack:
      throw usage_error("from", path.string() + " is a single view", "pictures of several views");
    default:
      return "integral";
  }
}

/// Returns whether the report beside a light field describes it. The report does not describe a folder of another format
/// beside a render, or a picture with another grid of views, which may be derived from the render's views.
bool matches_report(const fs::path& path, const LightFieldSource& source, const FormatOptions& options) {
  const LightFieldFormat& format = *source.format;
  if (format.states_cameras) return false;
  if (format.is_folder && format.name != "views") return path.filename().string().starts_with("frame_");
  return format.name != "eslf" || !options.views || !source.rendered || *options.views == source.rendered->film.grid;
}

/// Returns false for a folder of pictures with arbitrary names, which no render writes.
bool may_have_report(const fs::path& path, const std::string& from) {
  if (!from.empty() && find_format(from, "from").states_cameras) return false;
  std::error_code ignored;
  return !fs::is_directory(path, ignored) || format_of_folder(path);
}

double pixel_aspect_of(const Optics& optics, const ViewLayout& film) {
  const Vec2d pixel_mm = Vec2d(window_size_mm(optics)) / Vec2d(view_size(film, film_size(optics), "optics"));
  return pixel_mm.x / pixel_mm.y;
}

}  // namespace

LightFieldSource light_field_source(const fs::path& path, const std::string& from, const FormatOptions& options) {
  LightFieldSource source{nullptr, options};
  if (may_have_report(path, from)) source.rendering = rendering_of(path);
  if (source.rendering)
    source.rendered = rendered_views(with_parallax(source.rendering->optics, source.rendering->depth_scale));
  source.format = &find_format(from.empty() ? format_of(path, source) : from, "from");
  if (!matches_report(path, source, options)) source.rendering.reset(), source.rendered.reset();
  if (source.rendering && !source.rendering->has_depth_layer) source.options.with_depth = false;
  if (source.rendering && (sensor_lenses(source.rendering->optics) || has_fractional_lenses(source))) {
    if (!source.options.plenoptic) source.options.plenoptic.emplace();
    PlenopticCalibration& calibration = *source.options.plenoptic;
    calibration.optics = with_parallax(source.rendering->optics, source.rendering->depth_scale);
    if (!calibration.grid && has_fractional_lenses(source))
      calibration.grid = elemental_images(source.rendering->optics), calibration.inverted = true;
  }
  if (!source.rendered) return source;
  const ViewLayout& film = source.rendered->film;
  if (!source.options.views) source.options.views = film.grid;
  if (source.format->name == "views" || source.format->name == "eslf")
    source.options.pixel_aspect = pixel_aspect_of(source.rendering->optics, film);
  const bool named_by_quilt = parse_quilt_name(path).has_value();
  if (!source.options.tiles && film.kind == LayoutKind::kQuilt && !named_by_quilt) source.options.tiles = film.tiles;
  return source;
}

bool is_light_field_file_name(const fs::path& file) { return has_hdf5_name(file) || has_lytro_name(file); }

std::optional<std::string> format_by_name(const fs::path& picture) {
  if (parse_quilt_name(picture)) return "quilt";
  if (parse_stereo_name(picture)) return "stereo";
  if (has_quad_name(picture)) return std::string(kQuadFormat);
  if (has_rgbd_name(picture) || read_rgbd_side_file(picture)) return "rgbd";
  if (read_eslf_side_file(picture)) return "eslf";
  if (read_quilt_side_file(picture)) return "quilt";
  if (has_hdf5_name(picture)) return "hci-hdf5";
  if (is_lytro_raw(picture) || read_lens_grid(picture)) return "plenoptic";
  return std::nullopt;
}

Error unknown_format(const fs::path& picture) {
  const fs::path side = quilt_side_path(picture);
  if (is_regular_file_there(side))
    return usage_error("from",
                       "the format of " + picture.string() + " is unknown: the side file " + side.string() +
                           " describes neither a quilt nor an RGB-D picture",
                       "`from` with a format, or a side file such as " + std::string(kQuiltSideFileExample));
  if (const std::optional<ViewGrid> tiles = tiles_in_name(picture))
    return usage_error(
        "from",
        "the format of " + picture.string() + " is unknown: its name has " +
            fmt::format("qs{}x{}, but is not a complete quilt name", tiles->columns, tiles->rows),
        fmt::format("`from` quilt `quilt` {}x{}, or a name such as room_qs8x6a0.75.png", tiles->columns, tiles->rows));
  return usage_error(
      "from",
      "the format of " + picture.string() + " is unknown: it has no report.json or side file, and its name implies no format",
      "`from` with a format, such as `from` integral `views` 8x1 or `from` native `display` portrait (see "
      "lippmann help convert), "
      "or a name such as room_qs8x6a0.75.png");
}

const LightFieldFormat& format_of_light_field(const fs::path& in, const std::string& from) {
  if (!from.empty()) return find_format(from, "from");
  std::error_code ignored;
  const std::vector<fs::path> frames = fs::is_directory(in, ignored) ? light_field_frames(in, from) : std::vector<fs::path>();
  return *light_field_source(frames.empty() ? in : frames.front(), from, {}).format;
}

fs::path folder_of_pictures(const fs::path& folder) {
  std::error_code ignored;
  const std::optional<std::string> format = format_of_folder(folder);
  const bool has_images = format && keeps(*format, DataKind::kPoses) && fs::is_directory(folder / "images", ignored);
  return has_images ? folder / "images" : folder;
}

bool is_light_field_folder(const fs::path& folder) { return format_of_folder(folder) || is_picture_folder(folder); }

namespace {

/// Returns whether the views have the grid and the size that their report states. Views of row-interlaced stereo pictures have
/// half the height.
bool shows_rendered_views(const LightFieldSource& source, const LightField& field, const fs::path& path) {
  if (!source.rendered || source.rendered->film.grid != field.grid) return false;
  if (source.format->name != "stereo") return true;
  return view_size(source.rendered->film, film_size(source.rendering->optics), path.string()) == field.view_size;
}

}  // namespace

std::vector<fs::path> light_field_frames(const fs::path& folder, const std::string& from) {
  if (!from.empty() && find_format(from, "from").is_folder) return frame_folders_in(folder);
  std::vector<fs::path> frames = frame_pictures_in(folder);
  if (frames.empty() && from.empty()) frames = frame_folders_in(folder);
  if (frames.empty() && !format_of_folder(folder)) frames = described_pictures_in(folder, from);
  return frames;
}

OpenedLightField open_light_field(const fs::path& path, const std::string& from, const FormatOptions& options) {
  const LightFieldSource source = light_field_source(path, from, options);
  OpenedLightField opened{source.format->read(path, source.options)};
  opened.format = source.format->name;
  if (shows_rendered_views(source, opened.field, path)) {
    if (!opened.field.cameras) opened.field.cameras = source.rendered->cameras;
    opened.optics = source.rendering->optics;
  }
  if (options.cameras) state_cameras(opened.field, *options.cameras, path.string());
  return opened;
}

std::vector<fs::path> light_fields_in(const fs::path& path, const std::string& from) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
  if (!fs::is_directory(path, ignored)) return {path};
  std::vector<fs::path> frames = light_field_frames(path, from);
  if (!frames.empty()) return frames;
  if (from.empty() && !is_light_field_folder(path))
    throw Error(path.string(), "contains no frames or views",
                "frame_0000.png, frame_0001.png, ..., or a folder of views that `lippmann convert` reads");
  return {path};
}

}  // namespace lippmann
