#include "formats/hci_parameters.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace fs = std::filesystem;
namespace {

constexpr std::pair<const char*, std::string HciNotes::*> kTextNotes[] = {
    {"scene", &HciNotes::scene},     {"category", &HciNotes::category}, {"date", &HciNotes::date},
    {"version", &HciNotes::version}, {"authors", &HciNotes::authors},   {"contact", &HciNotes::contact}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

/// The values in parameters.cfg by key. Section headings are ignored, because no key occurs in two sections.
class Values {
 public:
  Values(std::string_view text, const std::string& where) : where_(where) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = trimmed(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::size_t equals = line.find('=');
      if (line.empty() || line[0] == '[' || line[0] == '#' || line[0] == ';' || equals == std::string_view::npos) continue;
      values_[std::string(trimmed(line.substr(0, equals)))] = trimmed(line.substr(equals + 1));
    }
  }

  bool has(const char* key) const { return values_.contains(key); }

  std::string text(const char* key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : found->second;
  }

  double number(const char* key, double lowest, double highest) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw Error(where_, fmt::format("has no {}", key));
    double value = 0.0;
    const char* end = found->second.data() + found->second.size();
    const auto read = std::from_chars(found->second.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !(value >= lowest && value <= highest))
      throw Error(where_, fmt::format("its {} is {}", key, shown(found->second)),
                  fmt::format("a number from {} to {}", lowest, highest));
    return value;
  }

  double number_or(const char* key, double otherwise) const {
    return values_.contains(key) ? number(key, -1e9, 1e9) : otherwise;
  }

  int count(const char* key, int highest) const {
    const double value = number(key, 1, highest);
    if (value != std::floor(value)) throw Error(where_, fmt::format("its {} is {}", key, value), "a whole number");
    return static_cast<int>(value);
  }

 private:
  const std::string& where_;
  std::map<std::string, std::string> values_;
};

/// Returns the position of the middle of the eyes relative to that of all eyes of the file, in the frame of the scene.
Vec3d shift_of_centre_m(const ViewCameras& cameras, const HciNotes& notes) {
  Vec2d middle(0.0);
  for (const Vec2d& eye : cameras.eyes_mm) middle += eye / static_cast<double>(cameras.eyes_mm.size());
  const auto metres = [](double mm) { return std::abs(mm) < 1e-6 ? 0.0 : 1e-3 * mm; };  // removes rounding errors
  Vec3d shift(metres(middle.x), metres(middle.y), 0.0);
  const Vec3d sine = glm::sin(notes.centre_camera_rad), cosine = glm::cos(notes.centre_camera_rad);
  for (const int axis : {0, 1, 2}) {
    double &a = shift[(axis + 1) % 3], &b = shift[(axis + 2) % 3];
    const double turned = cosine[axis] * a - sine[axis] * b;
    b = sine[axis] * a + cosine[axis] * b;
    a = turned;
  }
  return shift;
}

/// `baseline_mm`: distance between neighbouring eyes. `where`: the folder, whose name is that of a scene without a name.
HciParameters parameters_with(double baseline_mm, const LightField& field, const std::string& where) {
  const ViewCameras& cameras = *field.cameras;
  if (std::abs(cameras.pixel_mm.x / cameras.pixel_mm.y - 1.0) > 1e-4)
    throw Error(where, "the pixels are not square, as in views of cylindrical lenses, but the format requires square pixels",
                "views rendered with `camera-grid`, or with the `optics` microlens");
  HciParameters p;
  p.width = field.view_size.x, p.height = field.view_size.y;
  p.columns = field.grid.columns, p.rows = field.grid.rows;
  p.baseline_mm = baseline_mm;
  p.focus_distance_m = 1e-3 * cameras.distance_mm;
  p.focal_length_mm = p.sensor_size_mm * cameras.distance_mm / (cameras.pixel_mm.x * std::max(p.width, p.height));
  p.notes = field.hci.value_or(HciNotes());
  p.notes.centre_camera_m =
      p.notes.centre_camera_m.value_or(Vec3d(0.0, 0.0, p.focus_distance_m)) + shift_of_centre_m(cameras, p.notes);
  if (p.notes.scene.empty()) p.notes.scene = fs::path(where).filename().string();
  return p;
}

HciNotes notes_in(const Values& values) {
  HciNotes notes;
  notes.fstop = values.number_or("fstop", notes.fstop);
  for (const int axis : {0, 1, 2})
    if (const std::string key = fmt::format("center_cam_{}_m", "xyz"[axis]); values.has(key.c_str())) {
      if (!notes.centre_camera_m) notes.centre_camera_m = Vec3d(0.0);
      (*notes.centre_camera_m)[axis] = values.number_or(key.c_str(), 0.0);
    }
  for (const int axis : {0, 1, 2})
    notes.centre_camera_rad[axis] = values.number_or(fmt::format("center_cam_r{}_rad", "xyz"[axis]).c_str(), 0.0);
  for (const auto& [key, member] : kTextNotes)
    if (values.has(key)) notes.*member = values.text(key);
  notes.disparity_px = {values.number_or("disp_min", 0.0), values.number_or("disp_max", 0.0)};
  notes.frustum_disparity_px = {values.number_or("frustum_disp_min", 0.0), values.number_or("frustum_disp_max", 0.0)};
  notes.depth_map_scale = values.number_or("depth_map_scale", notes.depth_map_scale);
  return notes;
}

}  // namespace

HciParameters parse_hci_parameters(const std::string& text, const std::string& where) {
  constexpr int kMaxSide = 65536, kMaxCameras = 1024;
  constexpr double kLeast = 1e-6, kMost = 1e9;
  const Values values(text, where);
  HciParameters p;
  p.focal_length_mm = values.number("focal_length_mm", kLeast, kMost);
  p.sensor_size_mm = values.number("sensor_size_mm", kLeast, kMost);
  p.width = values.count("image_resolution_x_px", kMaxSide);
  p.height = values.count("image_resolution_y_px", kMaxSide);
  p.columns = values.count("num_cams_x", kMaxCameras);
  p.rows = values.count("num_cams_y", kMaxCameras);
  p.baseline_mm = values.number("baseline_mm", 0.0, kMost);
  if (p.baseline_mm == 0.0 && p.columns * p.rows > 1)
    throw Error(where, fmt::format("its baseline_mm is 0, but it has {}x{} cameras", p.columns, p.rows), "a number above 0");
  p.focus_distance_m = values.number("focus_distance_m", kLeast, kMost);
  p.notes = notes_in(values);
  return p;
}

std::string hci_parameters_text(const HciParameters& p) {
  std::string text;
  const auto line = [&](std::string_view key, const auto& value) { text += fmt::format("{} = {}\n", key, value); };
  text += "[intrinsics]\n";
  line("focal_length_mm", p.focal_length_mm);
  line("image_resolution_x_px", p.width);
  line("image_resolution_y_px", p.height);
  line("sensor_size_mm", p.sensor_size_mm);
  line("fstop", p.notes.fstop);
  text += "\n[extrinsics]\n";
  line("num_cams_x", p.columns);
  line("num_cams_y", p.rows);
  line("baseline_mm", p.baseline_mm);
  line("focus_distance_m", p.focus_distance_m);
  const Vec3d centre_m = p.notes.centre_camera_m.value_or(Vec3d(0.0, 0.0, p.focus_distance_m));
  for (const int axis : {0, 1, 2}) line(fmt::format("center_cam_{}_m", "xyz"[axis]), centre_m[axis]);
  for (const int axis : {0, 1, 2}) line(fmt::format("center_cam_r{}_rad", "xyz"[axis]), p.notes.centre_camera_rad[axis]);
  line("offset", -hci_disparity_px(p, INFINITY));
  text += "\n[meta]\n";
  for (const auto& [key, member] : kTextNotes) line(key, p.notes.*member);
  line("disp_min", p.notes.disparity_px.x);
  line("disp_max", p.notes.disparity_px.y);
  line("frustum_disp_min", p.notes.frustum_disparity_px.x);
  line("frustum_disp_max", p.notes.frustum_disparity_px.y);
  line("depth_map_scale", p.notes.depth_map_scale);
  return text;
}

std::optional<HciParameters> read_hci_parameters(const fs::path& folder) {
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  const fs::path path = folder / "parameters.cfg";
  if (!is_regular_file_there(path)) return std::nullopt;
  return parse_hci_parameters(read_recorded_text(path, kMaxBytes, "a parameters.cfg"), path.string());
}

void require_size(const HciParameters& p, const fs::path& picture, Vec2i size) {
  if (size == Vec2i(p.width, p.height)) return;
  throw Error((picture.parent_path() / "parameters.cfg").string(),
              fmt::format("its image_resolution_x_px and image_resolution_y_px are {} and {}, but {} has {}x{} pixels", p.width,
                          p.height, picture.filename().string(), size.x, size.y),
              "the size of the pictures");
}

fs::path write_hci_parameters(const fs::path& folder, const HciParameters& parameters) {
  const fs::path path = folder / "parameters.cfg";
  const std::string text = hci_parameters_text(parameters);
  write_file_atomically(path, std::as_bytes(std::span(text)));
  return path;
}

double hci_disparity_px(const HciParameters& p, double depth_m) {
  const double beta = p.baseline_mm * p.focal_length_mm * std::max(p.width, p.height), focus_mm = 1000.0 * p.focus_distance_m;
  return (beta * focus_mm / (1000.0 * depth_m) - beta) / (focus_mm * p.sensor_size_mm);
}

double hci_depth_m(const HciParameters& p, double disparity_px) {
  const double beta = p.baseline_mm * p.focal_length_mm * std::max(p.width, p.height);
  const double depth_m = beta * p.focus_distance_m / (disparity_px * 1000.0 * p.focus_distance_m * p.sensor_size_mm + beta);
  return depth_m > 0.0 ? depth_m : INFINITY;
}

HciParameters hci_parameters(const LightField& field, const std::string& where) {
  const std::optional<double> baseline = common_baseline_mm(*field.cameras, field.grid);
  if (!baseline)
    throw Error(where, "the spacing of the views is not uniform, but the format has a single baseline",
                "views rendered with `camera-grid`, or with the `optics` microlens; `keep` with equal steps");
  return parameters_with(*baseline, field, where);
}

HciParameters mean_hci_parameters(const LightField& field, const std::string& where) {
  const std::optional<double> baseline = common_baseline_mm(*field.cameras, field.grid);
  return parameters_with(baseline.value_or(mean_step(field.cameras->eyes_mm, field.grid)), field, where);
}

StatedCameras stated_cameras(const HciParameters& p) {
  const double sensor_width_mm = p.sensor_size_mm * p.width / std::max(p.width, p.height);
  return {p.baseline_mm, p.focal_length_mm, sensor_width_mm, 1000.0 * p.focus_distance_m};
}

ViewCameras hci_cameras(const HciParameters& p) {
  const double pixel_mm = p.sensor_size_mm * 1000.0 * p.focus_distance_m / (p.focal_length_mm * std::max(p.width, p.height));
  ViewCameras cameras{1000.0 * p.focus_distance_m, Vec2d(pixel_mm), 0.5 * Vec2d(p.width, p.height), {}};
  for (int row = 0; row < p.rows; ++row)
    for (int column = 0; column < p.columns; ++column)
      cameras.eyes_mm.push_back(p.baseline_mm * (Vec2d(column, row) - 0.5 * Vec2d(p.columns - 1, p.rows - 1)));
  return cameras;
}

}  // namespace lippmann
