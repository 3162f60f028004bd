#include "formats/miv_cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/printable.hpp"
#include "formats/stated_cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

void read_numbers(const JsonFields& json, std::string_view key, std::span<double> to, NumberRange range) {
  std::ranges::copy(json.numbers(key, to.size(), range), to.begin());
}

MivCamera camera_from(const JsonFields& json) {
  constexpr double kMost = 1e9;
  MivCamera camera;
  camera.name = json.text("Name");
  if (camera.name.empty() || camera.name.find_first_of("/\\") != std::string::npos || camera.name[0] == '.' ||
      printable(camera.name) != camera.name)
    json.reject("Name", "is " + shown(camera.name), "the name of a picture, without folder and ending");
  json.word_or("Projection", {"Perspective"}, 0);
  read_numbers(json, "Position", camera.position_m, {-kMost, kMost});
  read_numbers(json, "Rotation", camera.rotation_deg, {-360.0, 360.0});
  camera.resolution = Vec2i(json.pair("Resolution", {1.0, 65536.0}));
  camera.focal_px = json.pair("Focal", {1e-6, kMost});
  camera.principal_point_px = json.pair("Principle_point", {-kMost, kMost});
  const Vec2d range = json.pair("Depth_range", {1e-9, 1e30});
  if (!(range.x < range.y))
    json.reject("Depth_range", fmt::format("is {} to {}", range.x, range.y), "the nearest depth, then the farthest");
  camera.near_m = range.x, camera.far_m = range.y;
  camera.depth_bits = json.whole_or("BitDepthDepth", {1.0, 32.0}, camera.depth_bits);
  return camera;
}

/// Height in hundredths of a millimetre, rounded because rows of calibrated cameras are not exactly level.
double height_of(const MivCamera& camera) { return std::round(1e5 * camera.position_m[2]); }

Vec2d eye_of(const MivCamera& camera) { return 1e3 * Vec2d(-camera.position_m[1], camera.position_m[2]); }

bool is_turned(const MivCamera& camera) {
  return camera.rotation_deg[0] != 0.0 || camera.rotation_deg[1] != 0.0 || camera.rotation_deg[2] != 0.0;
}

/// Converts a vector from the axes (forward, left, up) to the axes (right, up, backwards).
Vec3d right_up_back(const Vec3d& v) { return {-v.y, v.z, -v.x}; }

/// Adds 0 because a file would show -0.
Vec3d forward_left_up(const Vec3d& v) { return Vec3d{-v.z, -v.x, v.y} + 0.0; }

}  // namespace

PosedCamera posed_camera(const MivCamera& camera, Vec2i size) {
  const auto turn = [&](int angle, const Vec3d& axis) {
    return glm::angleAxis(glm::radians(camera.rotation_deg[angle]), axis);
  };
  const glm::dmat3 world_from_camera = glm::mat3_cast(turn(0, {0, 0, 1}) * turn(1, {0, 1, 0}) * turn(2, {1, 0, 0}));
  const Vec3d &forward = world_from_camera[0], &left = world_from_camera[1], &up = world_from_camera[2];
  const auto& position = camera.position_m;
  return {size, camera.focal_px, camera.principal_point_px,
          glm::dmat3(right_up_back(-left), right_up_back(up), right_up_back(-forward)),
          1e3 * right_up_back({position[0], position[1], position[2]})};
}

MivCamera miv_camera(const PosedCamera& camera) {
  const Vec3d forward = forward_left_up(-camera.rotation[2]), left = forward_left_up(-camera.rotation[0]),
              up = forward_left_up(camera.rotation[1]), position = forward_left_up(camera.position_mm) / 1e3;
  // If the camera looks straight up or down, its yaw is arbitrary. The roll compensates it.
  const double yaw = std::atan2(forward.y, forward.x), cosine = std::cos(yaw), sine = std::sin(yaw);
  const double pitch = std::atan2(-forward.z, cosine * forward.x + sine * forward.y);
  const double roll = std::atan2(sine * up.x - cosine * up.y, cosine * left.y - sine * left.x);
  MivCamera result;
  std::ranges::copy(std::array{position.x, position.y, position.z}, result.position_m);
  std::ranges::transform(std::array{yaw, pitch, roll}, result.rotation_deg, [](double a) { return glm::degrees(a) + 0.0; });
  result.resolution = camera.size;
  result.focal_px = camera.focal_px, result.principal_point_px = camera.principal_px;
  return result;
}

std::vector<MivCamera> parse_miv_cameras(const std::string& text, const std::string& where) {
  constexpr std::size_t kMaxCameras = 4096;
  const Json json = json_from_text(text);
  if (json.is_discarded() || !json.is_object() || !json.contains("cameras") || !json["cameras"].is_array())
    throw json.is_discarded() ? json_error(text, where) : Error(where, "has no list of cameras");
  if (json["cameras"].empty() || json["cameras"].size() > kMaxCameras)
    throw Error(where, fmt::format("has {} cameras", json["cameras"].size()), fmt::format("1 to {}", kMaxCameras));
  std::vector<MivCamera> cameras;
  std::set<std::string> names;
  for (std::size_t i = 0; i < json["cameras"].size(); ++i) {
    const JsonFields fields(json["cameras"][i], where, fmt::format("cameras[{}]", i));
    if (fields.value("Name") == "viewport") continue;  // TMIV adds an entry "viewport" for the view that it synthesizes
    const MivCamera& camera = cameras.emplace_back(camera_from(fields));
    if (!names.insert(camera.name).second)
      throw Error(fmt::format("{}: cameras[{}].Name", where, i), fmt::format("repeats {}", shown(camera.name)),
                  "a name of its own");
  }
  return cameras;
}

std::string miv_cameras_text(const std::vector<MivCamera>& cameras, const std::string& content, bool depth) {
  Json list = Json::array(), names = Json::array();
  for (const MivCamera& c : cameras) {
    names.push_back(c.name);
    list.push_back({{"Name", c.name},
                    {"Position", {c.position_m[0], c.position_m[1], c.position_m[2]}},
                    {"Rotation", {c.rotation_deg[0], c.rotation_deg[1], c.rotation_deg[2]}},
                    {"Depthmap", depth ? 1 : 0},
                    {"Background", 0},
                    {"HasInvalidDepth", depth},
                    {"Depth_range", {c.near_m, c.far_m}},
                    {"Resolution", {c.resolution.x, c.resolution.y}},
                    {"Projection", "Perspective"},
                    {"Focal", {c.focal_px.x, c.focal_px.y}},
                    {"Principle_point", {c.principal_point_px.x, c.principal_point_px.y}},
                    {"BitDepthColor", 10},
                    {"BitDepthDepth", c.depth_bits},
                    {"ColorSpace", "YUV420"},
                    {"DepthColorSpace", "YUV420"}});
  }
  // TMIV requires a frame rate and a frame count, even for a single picture.
  const Json json{{"Version", "4.0"},   {"Content_name", content}, {"BoundingBox_center", {0, 0, 0}}, {"Fps", 30},
                  {"Frames_number", 1}, {"lengthsInMeters", true}, {"sourceCameraNames", names},      {"cameras", list}};
  return json_to_text(json) + '\n';
}

void set_cameras(const std::vector<MivCamera>& cameras, LightField& field) {
  field.cameras = cameras_of_miv(cameras);
  if (field.cameras) return;
  field.poses.emplace();
  for (const MivCamera& camera : cameras) field.poses->push_back(posed_camera(camera, field.view_size));
}

void warn_of_missing_cameras(const std::vector<MivCamera>& cameras, const std::string& where, const FormatOptions& options) {
  std::vector<Vec2d> eyes;
  for (const MivCamera& camera : cameras) eyes.push_back(eye_of(camera));
  warn_of_missing_cameras(eyes, where, options);
}

void sort_as_views(std::vector<MivCamera>& cameras) {
  if (std::ranges::any_of(cameras, is_turned)) return;
  std::stable_sort(cameras.begin(), cameras.end(), [](const MivCamera& a, const MivCamera& b) {
    return height_of(a) != height_of(b) ? height_of(a) < height_of(b) : a.position_m[1] > b.position_m[1];
  });
}

ViewGrid grid_of_cameras(const std::vector<MivCamera>& cameras, std::optional<ViewGrid> views, const std::string& where) {
  const int count = static_cast<int>(cameras.size());
  int rows = 1;
  if (std::ranges::none_of(cameras, is_turned))
    for (std::size_t i = 1; i < cameras.size(); ++i) rows += height_of(cameras[i]) != height_of(cameras[i - 1]);
  const ViewGrid grid = views.value_or(count % rows == 0 ? ViewGrid{count / rows, rows} : ViewGrid{count, 1});
  if (grid.count() != count)
    throw usage_error("views", fmt::format("{}x{} does not match the {} views in {}", grid.columns, grid.rows, count, where));
  return grid;
}

std::vector<MivCamera> miv_cameras(const ViewCameras& cameras, Vec2i view_size, const std::vector<std::string>& names,
                                   double near_m, double far_m) {
  std::vector<MivCamera> all;
  for (std::size_t view = 0; view < cameras.eyes_mm.size(); ++view) {
    const Vec2d eye = cameras.eyes_mm[view], straight_ahead = eye / cameras.pixel_mm * Vec2d(1.0, -1.0);
    MivCamera camera;
    camera.name = names[view];
    camera.position_m[1] = -1e-3 * eye.x, camera.position_m[2] = 1e-3 * eye.y;
    camera.near_m = near_m, camera.far_m = far_m;
    camera.resolution = view_size;
    camera.focal_px = cameras.distance_mm / cameras.pixel_mm;
    camera.principal_point_px = cameras.centre_px + straight_ahead;
    all.push_back(camera);
  }
  return all;
}

std::vector<MivCamera> miv_cameras(const LightField& field, const std::vector<std::string>& names, double near_m,
                                   double far_m) {
  if (field.cameras) return miv_cameras(*field.cameras, field.view_size, names, near_m, far_m);
  std::vector<MivCamera> all;
  for (std::size_t view = 0; view < names.size(); ++view) {
    MivCamera& camera = all.emplace_back(miv_camera((*field.poses)[view]));
    camera.name = names[view];
    camera.near_m = near_m, camera.far_m = far_m;
  }
  return all;
}

std::optional<ViewCameras> cameras_of_miv(const std::vector<MivCamera>& cameras) {
  const MivCamera& first = cameras.front();
  // If the eye moves by m mm and the principal point shifts by p pixels, the plane with zero disparity is at the distance
  // focal_px * m / p.
  double distance = 0.0;
  for (const MivCamera& c : cameras) {
    const Vec2d by_mm = eye_of(c) - eye_of(first), by_px = (c.principal_point_px - first.principal_point_px) * Vec2d(1.0, -1.0);
    for (const int axis : {0, 1})
      if (by_px[axis] != 0.0 && distance == 0.0) distance = first.focal_px[axis] * by_mm[axis] / by_px[axis];
  }
  if (!(distance > 0.0) || !std::isfinite(distance)) return std::nullopt;
  ViewCameras result{distance, distance / first.focal_px, {}, {}};
  result.centre_px = first.principal_point_px - eye_of(first) / result.pixel_mm * Vec2d(1.0, -1.0);
  for (const MivCamera& c : cameras) {
    const Vec2d centre = c.principal_point_px - eye_of(c) / result.pixel_mm * Vec2d(1.0, -1.0);
    if (is_turned(c) || c.position_m[0] != first.position_m[0] || c.focal_px != first.focal_px ||
        glm::distance(centre, result.centre_px) > 0.01)
      return std::nullopt;
    result.eyes_mm.push_back(eye_of(c));
  }
  return result;
}

}  // namespace lippmann
