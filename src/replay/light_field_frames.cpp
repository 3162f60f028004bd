#include "lippmann/replay/light_field_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "formats/light_field_source.hpp"
#include "formats/quad_name.hpp"
#include "formats/rgbd_name.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/formats/quilt_name.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/view_spacing.hpp"
#include "replay/no_light_field.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr double kWindowHeightMm = 100.0, kDistanceMm = 300.0, kConeDeg = 40.0, kGridAngleDeg = 10.0;

Panel quilt_panel(const LightField& field, double pixel_mm) {
  return {field.view_size.x * field.grid.columns, field.view_size.y * field.grid.rows, static_cast<float>(pixel_mm)};
}

double pixel_width_mm(const LightField& field) { return field.aspect * kWindowHeightMm / field.view_size.x; }

Picture panel_picture(const LightField& field, const ViewLayout& film) {
  const Vec2i size = picture_size(film, field.view_size);
  Picture picture = blank(field.stack, size);
  move_pixels(field.stack, {}, picture, pixels_of_views(film, field.view_size, size));
  return picture;
}

ViewLayout film_of(const Optics& optics, const std::string& where) {
  if (const std::optional<RenderedViews> rendered = rendered_views(optics)) return rendered->film;
  throw Error(where, "its views cannot be laid out below lenses again, because the lenses have no whole number of pixels",
              "pictures of `layout` integral or native");
}

bool is_as_shown(const fs::path& picture, const std::string& layout, const Optics& optics) {
  if (is_single_view(optics)) return true;
  const std::optional<QuiltName> name = parse_quilt_name(picture);
  const std::optional<ViewTiles> views = view_tiles(optics);
  if (name) return views && name->tiles == ViewGrid{views->columns, views->rows};
  if (layout == "quilt") return views.has_value();
  if (layout == "eslf" || layout == "stereo" || has_quad_name(picture)) return false;
  return layout != "integral" || has_lenses(optics);
}

FormatOptions options_of(const LightFieldHints& hints) {
  FormatOptions options;
  options.views = hints.views, options.tiles = hints.tiles, options.display = hints.display, options.warn = hints.warn;
  return options;
}

/// Sets frames.read to a function that reads a frame and rearranges its views for the panel.
LightFieldFrames rearranged(LightFieldFrames frames, const std::string& from, const FormatOptions& options) {
  const auto files = std::make_shared<std::vector<fs::path>>(frames.files);
  frames.read = [files, from, options, optics = frames.optics](std::size_t index) {
    const fs::path& file = (*files)[index];
    const LightFieldSource source = light_field_source(file, from, options);
    return panel_of(source.format->read(file, source.options), optics, file.string());
  };
  return frames;
}

/// Sets frames.read to a function that reads a frame without rearranging its pixels.
LightFieldFrames as_shown(LightFieldFrames frames) {
  const RenderedFrames pictures{frames.optics, frames.files, frames.frames_per_second};
  frames.read = [pictures](std::size_t index) { return read_rendered_panel(pictures, index); };
  return frames;
}

/// For a finished render, sets the optics, the frame rate and the function that reads a frame.
LightFieldFrames of_render(LightFieldFrames frames, const Rendering& rendering, const LightFieldHints& hints) {
  const fs::path& first = frames.files.front();
  if (hints.display && !hints.is_other_display)
    throw usage_error("display", "has no effect: report.json states the display of " + first.string(),
                      "pictures without a report.json");
  if (hints.view_angle_deg || hints.cone_ends)
    throw usage_error(hints.cone_ends ? "cone-ends" : "view-angle", "has no effect: report.json states the cameras",
                      "views whose cameras are unknown");
  if (rendering.mirrored)
    throw Error(first.string(), "the pictures are mirrored, to be printed on the back of a sheet", "a render without `mirror`");
  frames.optics = rendering.optics;
  frames.frames_per_second = rendering.frames_per_second.value_or(frames.frames_per_second);
  std::error_code ignored;
  const std::string& layout = hints.from.empty() ? rendering.layout : hints.from;
  if (fs::is_directory(first, ignored) || !is_as_shown(first, layout, rendering.optics))
    return rearranged(std::move(frames), hints.from, options_of(hints));
  if (hints.views || hints.tiles)
    throw usage_error(hints.views ? "views" : "quilt",
                      "has no effect: report.json states the arrangement of the views in " + first.string(),
                      "pictures without a report.json, or `from` with another format");
  return as_shown(std::move(frames));
}

/// For pictures in the pixel layout of a display, without a report, sets the optics and the function that reads a frame.
LightFieldFrames of_panel(LightFieldFrames frames, const LightFieldHints& hints) {
  for (const auto& [given, flag] :
       {std::pair(hints.view_angle_deg.has_value(), "view-angle"), std::pair(hints.views.has_value(), "views"),
        std::pair(hints.tiles.has_value(), "quilt"), std::pair(hints.cone_ends, "cone-ends")})
    if (given)
      throw usage_error(flag, "has no effect on the interlaced frame of a panel",
                        fmt::format("no `{}`, or views or a quilt in place of the interlaced frame", flag));
  frames.optics = native_optics(*hints.display), frames.is_panel = true;
  const Vec2i panel(frames.optics.panel.width, frames.optics.panel.height);
  const Vec2i size = size_of(read_picture(frames.files.front()));
  if (size != panel)
    throw Error(
        frames.files.front().string(),
        fmt::format("has {}x{} pixels, but the panel of {} has {}x{}", size.x, size.y, hints.display->name, panel.x, panel.y),
        "a frame of that panel; for other formats `from`, `views` or `quilt`");
  return as_shown(std::move(frames));
}

void refuse_unused(const LightFieldHints& hints, const LightFieldFormat& format) {
  const auto refuse = [&](bool given, const char* flag, const char* accepted) {
    if (given) throw usage_error(flag, fmt::format("has no effect on the format {}", format.name), accepted);
  };
  refuse(hints.views && !format.reads.views, "views", "`from` integral, eslf, plenoptic, views, quilt, hci or native");
  refuse(hints.tiles && !format.reads.tiles, "quilt", "`from` quilt");
}

/// Throws if hints on cameras are given, because the file states its cameras.
void refuse_stated_cameras(const LightFieldHints& hints, const fs::path& file) {
  const auto refuse = [&](bool given, const char* flag) {
    if (given)
      throw usage_error(flag, fmt::format("has no effect: {} states its cameras", file.string()),
                        "views whose cameras are unknown");
  };
  refuse(hints.view_angle_deg.has_value(), "view-angle");
  refuse(hints.cone_ends, "cone-ends");
  refuse(hints.display && !hints.is_other_display, "display");
}

Optics quilt_for(Display display, const LightField& field, const LightFieldHints& hints) {
  const ViewGrid& grid = field.grid;
  if (grid.rows > 1)
    throw usage_error("display", fmt::format("has no effect on a grid of {}x{} views", grid.columns, grid.rows),
                      "a row of views, or the frame of its panel");
  if (hints.view_angle_deg) display.view_cone_deg = *hints.view_angle_deg;
  display.quilt = DisplayQuilt{grid.columns, grid.rows, grid.columns * field.view_size.x, field.view_size.y, field.aspect};
  return with_cone_ends(*quilt_optics(display), hints.cone_ends);
}

/// For a light field without a report, sets the optics, the assumptions and the function that reads a frame.
LightFieldFrames of_format(LightFieldFrames frames, const LightFieldSource& source, const LightFieldHints& hints) {
  const fs::path& first = frames.files.front();
  const LightField field = source.format->read(first, source.options);
  if (has_camera_grid(field)) {
    refuse_stated_cameras(hints, first);
    frames.optics = optics_of_cameras(field, first.string());
  } else if (hints.display && !hints.is_other_display) {
    frames.optics = quilt_for(*hints.display, field, hints);
  } else {
    if (hints.cone_ends && field.grid.rows > 1)
      throw usage_error("cone-ends", "has no effect on a grid of cameras", "a row of views");
    if (field.poses && hints.is_other_display && hints.warn)
      hints.warn(fmt::format(
          "The cameras of {} do not share a plane and a window. Their views are shown in order, from left to right.",
          first.string()));
    frames.optics = assumed_optics(field, hints.view_angle_deg, hints.cone_ends);
    frames.assumption = describe_assumed_optics(field, frames.optics, hints.view_angle_deg, first.string());
    frames.assumption += hints.view_angle_deg ? "." : "; `view-angle` sets the angle.";
  }
  return rearranged(std::move(frames), hints.from, source.options);
}

}  // namespace

RenderedPanel panel_of(const LightField& field, const Optics& optics, const std::string& where) {
  const ViewLayout film = film_of(optics, where);
  const Vec2i size = picture_size(film, field.view_size), panel = picture_size(optics);
  if (field.grid != film.grid)
    throw Error(where, fmt::format("has {}x{} views", field.grid.columns, field.grid.rows),
                fmt::format("{}x{}, as in its report or the first frame", film.grid.columns, film.grid.rows));
  const bool is_quilt = film.kind == LayoutKind::kQuilt;  // a quilt may have padding, which is cut off
  const Vec2i tiles = is_quilt ? Vec2i(film.tiles.columns, film.tiles.rows) : Vec2i(1, 1);
  if (size / tiles != panel / tiles)
    throw Error(where, fmt::format("its views make {}x{} pixels, but the panel has {}x{}", size.x, size.y, panel.x, panel.y),
                "the pictures as the render wrote them");
  RenderedPanel rendered{optics, to_linear(panel_picture(field, film))};
  rendered.optics.panel.width = size.x, rendered.optics.panel.height = size.y;
  return rendered;
}

bool has_camera_grid(const LightField& field) {
  if (!field.cameras) return false;
  const std::optional<double> baseline = common_baseline_mm(*field.cameras, field.grid);
  return baseline && (field.grid.count() == 1 || *baseline > 0.0);
}

Optics optics_of_cameras(const LightField& field, const std::string& where) {
  const ViewCameras& cameras = *field.cameras;
  const std::optional<double> baseline = common_baseline_mm(cameras, field.grid);
  if (!has_camera_grid(field))
    throw Error(where, "its cameras do not stand in a regular grid", "cameras that are equally far apart across and up");
  Vec2d middle(0.0);
  for (const Vec2d& eye : cameras.eyes_mm) middle += eye / static_cast<double>(cameras.eyes_mm.size());
  const Vec2d off_axis_px = cameras.centre_px + middle * Vec2d(1.0, -1.0) / cameras.pixel_mm - 0.5 * Vec2d(field.view_size);
  const double tolerance_px = 0.01 * field.view_size.x;
  if (std::abs(off_axis_px.x) > tolerance_px)
    throw Error(where, fmt::format("the optical axes of its cameras are {:.4g} pixels off centre", off_axis_px.x),
                "cameras whose axes meet the vertical line through the middle of the display");
  const bool is_level = std::abs(off_axis_px.y) <= tolerance_px;
  const auto eye_height_mm = static_cast<float>(is_level ? 0.0 : -off_axis_px.y * cameras.pixel_mm.y);
  Optics optics;
  optics.panel = quilt_panel(field, cameras.pixel_mm.x);
  if (field.grid.count() == 1) {
    optics.model = SingleView{static_cast<float>(cameras.distance_mm), {}, eye_height_mm};
    return optics;
  }
  MultiView views{field.grid.columns, field.grid.rows};
  views.distance_mm = static_cast<float>(cameras.distance_mm);
  views.baseline_mm = static_cast<float>(*baseline);
  views.eye_height_mm = eye_height_mm;
  views.pixel_height = static_cast<float>(cameras.pixel_mm.y / cameras.pixel_mm.x);
  optics.model = views;
  validate(optics);
  return optics;
}

MultiView assumed_views(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends) {
  const bool is_grid = field.grid.rows > 1;
  const double angle = radians(view_angle_deg.value_or(is_grid ? kGridAngleDeg : kConeDeg));
  MultiView views{field.grid.columns, field.grid.rows};
  views.distance_mm = kDistanceMm;
  // The views are stretched to the assumed display, so pixels need not be square.
  views.pixel_height = static_cast<float>(kWindowHeightMm / field.view_size.y / pixel_width_mm(field));
  if (is_grid)
    views.baseline_mm = static_cast<float>(2.0 * kDistanceMm * std::tan(0.5 * angle) / std::max(field.grid.columns - 1, 1));
  else
    views.view_cone = static_cast<float>(angle), views.cone_ends_included = cone_ends;
  return views;
}

Optics assumed_optics(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends) {
  Optics optics;
  optics.panel = quilt_panel(field, pixel_width_mm(field));
  optics.model = assumed_views(field, view_angle_deg, cone_ends);
  validate(optics);
  return optics;
}

std::string describe_assumed_optics(const LightField& field, const Optics& optics, std::optional<double> view_angle_deg,
                                    const std::string& where) {
  std::string text = fmt::format("The cameras of {} {}. Assumed: a display {:.4g} mm high, seen from {:.4g} mm", where,
                                 field.poses     ? "do not share a plane and a window"
                                 : field.cameras ? "are not equally far apart"
                                                 : "are unknown",
                                 kWindowHeightMm, kDistanceMm);
  if (const std::string spacing = view_spacing(optics); !spacing.empty())
    text += ", and " + spacing;
  else if (!view_angle_deg)
    text += fmt::format(", and views over {:.4g} degrees", kGridAngleDeg);
  return text;
}

LightFieldFrames find_light_field_frames(const fs::path& in, const LightFieldHints& hints) {
  if (hints.from.empty()) require_light_field(in);
  LightFieldFrames frames;
  frames.files = light_fields_in(in, hints.from);
  const fs::path& first = frames.files.front();
  std::error_code ignored;
  const bool is_folder = fs::is_directory(first, ignored);
  frames.folder = first == in && is_folder ? in : first.parent_path();
  if (!hints.report.empty()) return of_render(std::move(frames), read_rendering(hints.report), hints);
  if (!is_folder && hints.from.empty() && !has_rgbd_name(first)) {
    if (const std::optional<Rendering> rendering = rendering_of(first)) return of_render(std::move(frames), *rendering, hints);
    if (!is_light_field_file_name(first)) require_picture_name(first);
    if (!format_by_name(first) && hints.display) return of_panel(std::move(frames), hints);
    if (!format_by_name(first)) throw unknown_format(first);
  }
  const LightFieldSource source = light_field_source(first, hints.from, options_of(hints));
  if (source.rendering) return of_render(std::move(frames), *source.rendering, hints);
  if (source.format->name == "native" && hints.display) return of_panel(std::move(frames), hints);
  refuse_unused(hints, *source.format);
  return of_format(std::move(frames), source, hints);
}

}  // namespace lippmann
