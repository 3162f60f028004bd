#include "replay/picture_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/folder_entries.hpp"
#include "core/regular_file.hpp"
#include "formats/frame_names.hpp"
#include "formats/light_field_source.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/optics/viewing.hpp"
#include "replay/no_light_field.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string samples_text(const Picture& picture) {
  if (std::holds_alternative<Image8>(picture)) return "8 bits";
  return std::holds_alternative<Image16>(picture) ? "16 bits" : "floats";
}

PictureInfo describe_video(const fs::path& file) {
  PictureInfo info{.first = file, .format = "video"};
  VideoReader video(file);
  const std::optional<Image8> frame = video.next();
  if (frame) info.picture_px = {frame->width, frame->height}, info.samples = samples_text(*frame);
  if (const std::optional<std::string> stated = format_by_name(file)) info.problem = "its frames are " + *stated + " pictures";
  return info;
}

fs::path picture_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  for (const fs::directory_entry& entry : entries_of(path))
    if (is_picture_name(entry.path())) return entry.path();
  return {};
}

fs::path side_file_of(const fs::path& path) {
  std::error_code ignored;
  std::vector<fs::path> candidates;
  if (fs::is_directory(path, ignored))
    candidates = {path / "cameras.json", path / "parameters.cfg", path / "transforms.json",          path / "poses_bounds.npy",
                  path / "views.json",   path / "report.json",    path.parent_path() / "report.json"};
  else
    candidates = {fs::path(path) += ".json", path.parent_path() / "report.json"};
  const auto found = std::find_if(candidates.begin(), candidates.end(), is_regular_file_there);
  return found == candidates.end() ? fs::path() : *found;
}

std::string cameras_text(const LightField& field) {
  if (field.poses) return "poses, each camera turned by itself";
  if (field.cameras) {
    const std::optional<double> baseline = common_baseline_mm(*field.cameras, field.grid);
    const std::string distance = fmt::format("{:.4g} mm from the display", field.cameras->distance_mm);
    if (field.grid.count() == 1) return "at " + distance;
    return baseline ? fmt::format("{:.4g} mm apart, {}", *baseline, distance) : fmt::format("irregular, {}", distance);
  }
  return field.positions ? "positions without a unit, at an unknown distance" : std::string();
}

/// Sets `info` for a rendered image that cannot be divided into views. Returns false for other images.
bool describe_rendered(const fs::path& file, PictureInfo& info) {
  const std::optional<Rendering> rendering = rendering_of(file);
  if (!rendering) return false;
  const bool single = is_single_view(rendering->optics);
  if (!single && rendering->layout != "native" && rendered_views(rendering->optics)) return false;
  info.format = single ? "view" : "panel";
  info.cameras = fmt::format("{:.4g} mm from the display", viewing_distance_mm(rendering->optics));
  info.has_depth = rendering->has_depth_layer && rendered_depth(file).has_value();
  return true;
}

void describe_views(const fs::path& path, PictureInfo& info) {
  OpenedLightField opened;
  try {
    opened = open_light_field(path, "", {.with_depth = true});
  } catch (const Error& error) {
    const bool is_of_side_file = !info.side_file.empty() && error.where().starts_with(info.side_file.string());
    info.problem = is_of_side_file ? error.where() + ": " + error.problem() : error.problem();
    if (!error.accepted().empty()) info.problem += "; accepted: " + error.accepted();
    return;
  }
  info.format = opened.format;
  info.views = opened.field.grid, info.view_px = opened.field.view_size;
  const bool is_assumed = opened.format == "rgbd" && info.side_file.empty();
  if (!is_assumed) info.cameras = cameras_text(opened.field);
  info.has_depth = opened.field.depth.has_value();
}

}  // namespace

PictureInfo describe_picture(const fs::path& in) {
  std::error_code ignored;
  if (is_video_name(in) && is_regular_file_there(in)) return describe_video(in);
  require_light_field(in);
  const std::vector<fs::path> frames = light_fields_in(in, "");
  PictureInfo info{.first = frames.front(), .frames = static_cast<int>(frames.size())};
  if (const fs::path file = picture_of(info.first); !file.empty() && !is_light_field_file_name(file)) {
    const Picture picture = read_picture(file);
    info.picture_px = size_of(picture), info.samples = samples_text(picture);
  }
  info.side_file = side_file_of(info.first);
  if (fs::is_directory(info.first, ignored) || !describe_rendered(info.first, info)) describe_views(info.first, info);
  return info;
}

nlohmann::ordered_json to_json(const PictureInfo& info) {
  nlohmann::ordered_json json{{"first", info.first.string()},
                              {"frames", info.frames},
                              {"format", info.format.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(info.format)},
                              {"size", {info.picture_px.x, info.picture_px.y}},
                              {"samples", info.samples}};
  json["views"] = nullptr, json["view_size"] = nullptr;
  if (info.views) json["views"] = {info.views->columns, info.views->rows}, json["view_size"] = {info.view_px.x, info.view_px.y};
  json["cameras"] = info.cameras.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(info.cameras);
  json["depth"] = info.has_depth;
  json["side_file"] = info.side_file.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(info.side_file.string());
  if (!info.problem.empty()) json["problem"] = info.problem;
  return json;
}

std::string to_text(const PictureInfo& info) {
  const auto or_unknown = [](const std::string& text) { return text.empty() ? "unknown" : text; };
  std::string text = fmt::format("{}: {}\n", info.first.string(), info.format.empty() ? "format unknown" : info.format);
  const auto line = [&](std::string_view key, const std::string& value) { text += fmt::format("{:<10} {}\n", key, value); };
  if (info.frames > 1) line("frames", fmt::format("{}, this is the first", info.frames));
  if (info.picture_px.x > 0) line("pixels", fmt::format("{}x{}, {}", info.picture_px.x, info.picture_px.y, info.samples));
  if (info.views)
    line("views", fmt::format("{}x{} of {}x{} pixels", info.views->columns, info.views->rows, info.view_px.x, info.view_px.y));
  if (info.format != "video") {
    line("cameras", or_unknown(info.cameras));
    line("depth", info.has_depth ? "yes" : "no");
    line("side file", info.side_file.empty() ? "none" : info.side_file.string());
  }
  if (!info.problem.empty()) line("note", info.problem);
  return text;
}

}  // namespace lippmann
