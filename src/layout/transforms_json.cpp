#include "layout/transforms_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

constexpr NumberRange kFocalRange{1e-3, 1e9}, kSizeRange{1.0, 65536.0}, kAngleRange{1e-6, 3.1415}, kPlaceRange{-1e9, 1e9};

void check_pinhole(const JsonFields& json) {
  for (const char* key : {"k1", "k2", "k3", "k4", "p1", "p2"})
    if (json.number_or(key, kAnyNumber, 0.0) != 0.0) json.reject(key, "is a lens distortion", "0, pictures without distortion");
  if (json.flag_or("is_fisheye", false)) json.reject("is_fisheye", "is true", "pinhole cameras");
  const std::string model = json.text_or("camera_model", "PINHOLE");
  if (model != "PINHOLE" && model != "SIMPLE_PINHOLE" && model != "OPENCV" && model != "PERSPECTIVE")
    json.reject("camera_model", "is " + model, "PINHOLE, SIMPLE_PINHOLE or OPENCV without distortion");
}

/// Reads the intrinsics in an object. They replace earlier values in `picture`.
void read_intrinsics(const JsonFields& json, PosedPicture& picture) {
  PosedCamera& camera = picture.camera;
  check_pinhole(json);
  if (json.has("w") || json.has("h")) camera.size = {json.whole("w", kSizeRange), json.whole("h", kSizeRange)};
  if (json.has("fl_x") || json.has("fl_y")) {
    camera.focal_px.x = json.number("fl_x", kFocalRange);
    camera.focal_px.y = json.number_or("fl_y", kFocalRange, camera.focal_px.x);
    picture.angle_x = 0.0;
  } else if (json.has("camera_angle_x")) {
    picture.angle_x = json.number("camera_angle_x", kAngleRange);
  }
  if (!json.has("cx") && !json.has("cy")) return;
  camera.principal_px = {json.number("cx", kPlaceRange), json.number("cy", kPlaceRange)};
  picture.has_principal_px = true;
}

void read_matrix(const JsonFields& json, PosedCamera& camera, const std::string& where) {
  const Json& matrix = json.value("transform_matrix");
  if (!matrix.is_array() || (matrix.size() != 3 && matrix.size() != 4))
    json.reject("transform_matrix", matrix.is_null() ? "is missing" : "is not a 4x4 matrix", "four rows of four numbers");
  double rows[9];
  for (std::size_t row = 0; row < 3; ++row) {
    const std::vector<double> numbers = json.numbers_in("transform_matrix", matrix[row], 4, kPlaceRange);
    std::copy_n(numbers.begin(), 3, rows + 3 * row);
    camera.position_mm[static_cast<int>(row)] = kMmPerUnit * numbers[3];
  }
  if (matrix.size() == 4 && json.numbers_in("transform_matrix", matrix[3], 4) != std::vector<double>{0.0, 0.0, 0.0, 1.0})
    json.reject("transform_matrix", "has a last row other than 0 0 0 1", "an affine matrix");
  camera.rotation = checked_rotation(rows, where + ": transform_matrix");
}

PosedPicture frame_from(const JsonFields& json, PosedPicture picture, const std::string& where) {
  read_intrinsics(json, picture);
  picture.picture = json.text("file_path");
  std::replace(picture.picture.begin(), picture.picture.end(), '\\', '/');
  check_inner_path(picture.picture, where + ": file_path");
  picture.depth = json.text_or("depth_file_path", "");
  if (!picture.depth.empty()) check_inner_path(picture.depth, where + ": depth_file_path");
  if (picture.camera.focal_px.x <= 0.0 && picture.angle_x <= 0.0)
    json.reject("fl_x", "is missing", "fl_x in pixels, or camera_angle_x in radians");
  read_matrix(json, picture.camera, where);
  return picture;
}

Json matrix_of(const PosedCamera& camera) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({camera.rotation[0][row] + 0.0, camera.rotation[1][row] + 0.0, camera.rotation[2][row] + 0.0,
                    camera.position_mm[row] / kMmPerUnit});
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

void write_intrinsics(const PosedCamera& camera, Json& json) {
  json["w"] = camera.size.x, json["h"] = camera.size.y;
  json["fl_x"] = camera.focal_px.x, json["fl_y"] = camera.focal_px.y;
  json["cx"] = camera.principal_px.x, json["cy"] = camera.principal_px.y;
}

/// Adds the lists of pictures that nerfstudio reads. nerfstudio requires all three lists.
void list_split(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test, Json& json) {
  for (const char* key : {"train_filenames", "val_filenames", "test_filenames"}) {
    Json& names = json[key] = Json::array();
    const bool test = std::string_view(key) != "train_filenames";
    for (std::size_t i = 0; i < pictures.size(); ++i)
      if (is_test[i] == test) names.push_back(pictures[i].picture);
  }
}

bool same_intrinsics(const PosedCamera& a, const PosedCamera& b) {
  return a.size == b.size && a.focal_px == b.focal_px && a.principal_px == b.principal_px;
}

}  // namespace

std::vector<PosedPicture> parse_transforms(const std::string& text, const std::string& where) {
  constexpr std::size_t kMaxFrames = 65536;
  const Json json = json_from_text(text);
  if (json.is_discarded() || !json.is_object()) throw Error(where, "is not JSON with a list of frames");
  const JsonFields fields(json, where, "");
  const Json& frames = fields.value("frames");
  if (!frames.is_array() || frames.empty() || frames.size() > kMaxFrames)
    throw Error(where, frames.is_array() ? fmt::format("has {} frames", frames.size()) : "has no list of frames",
                fmt::format("frames, 1 to {}", kMaxFrames));
  PosedPicture common;
  common.has_principal_px = false;
  read_intrinsics(fields, common);
  std::vector<PosedPicture> pictures;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    common.entry = fmt::format("frames[{}]", i);
    pictures.push_back(frame_from(JsonFields(frames[i], where, common.entry), common, where + ": " + common.entry));
  }
  return pictures;
}

std::string transforms_text(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test) {
  const PosedCamera& first = pictures.front().camera;
  const bool is_common =
      std::all_of(pictures.begin(), pictures.end(), [&](const PosedPicture& p) { return same_intrinsics(p.camera, first); });
  Json json{{"camera_model", "PINHOLE"}, {"camera_angle_x", 2.0 * std::atan(0.5 * first.size.x / first.focal_px.x)}};
  if (is_common) write_intrinsics(first, json);
  if (!pictures.front().depth.empty())
    json["depth"] = {{"depth_file_path", "planar depth (z), along the camera's axis"},
                     {"ray_length_file_path", "length of the ray from the camera"},
                     {"unit_scale_factor", 1.0 / kMmPerUnit},
                     {"nothing", 0}};
  if (!is_test.empty()) list_split(pictures, is_test, json);
  json["frames"] = Json::array();
  for (const PosedPicture& picture : pictures) {
    Json frame{{"file_path", picture.picture}};
    if (!picture.depth.empty()) {
      frame["depth_file_path"] = picture.depth;
      frame["ray_length_file_path"] = ray_length_name(picture.depth);
    }
    if (!is_common) write_intrinsics(picture.camera, frame);
    frame["transform_matrix"] = matrix_of(picture.camera);
    json["frames"].push_back(std::move(frame));
  }
  return json_to_text(json) + '\n';
}

}  // namespace lippmann
