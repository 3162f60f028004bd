#include "formats/transforms_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "formats/picture_folder.hpp"
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

/// The intrinsics in `json` replace earlier values in `picture`.
void read_intrinsics(const JsonFields& json, PosedPicture& picture) {
  PosedCamera& camera = picture.camera;
  check_pinhole(json);
  camera.size = {json.whole_or("w", kSizeRange, camera.size.x), json.whole_or("h", kSizeRange, camera.size.y)};
  if (json.has("camera_angle_x")) {
    picture.angle_x = json.number("camera_angle_x", kAngleRange);
    camera.focal_px = Vec2d(0.0);
  }
  camera.focal_px.x = json.number_or("fl_x", kFocalRange, camera.focal_px.x);
  camera.focal_px.y = json.number_or("fl_y", kFocalRange, camera.focal_px.y);
  camera.principal_px.x = json.number_or("cx", kPlaceRange, camera.principal_px.x);
  camera.principal_px.y = json.number_or("cy", kPlaceRange, camera.principal_px.y);
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

PosedPicture frame_from(const JsonFields& json, PosedPicture picture) {
  read_intrinsics(json, picture);
  picture.picture = json.text("file_path");
  std::replace(picture.picture.begin(), picture.picture.end(), '\\', '/');
  check_inner_path(picture.picture, picture.entry + ": file_path");
  picture.depth = json.text_or("depth_file_path", "");
  if (!picture.depth.empty()) check_inner_path(picture.depth, picture.entry + ": depth_file_path");
  if (picture.camera.focal_px.x <= 0.0 && picture.angle_x <= 0.0)
    json.reject("fl_x", "is missing", "fl_x in pixels, or camera_angle_x in radians");
  read_matrix(json, picture.camera, picture.entry);
  if (json.has("time")) picture.time = json.number("time");
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

constexpr std::pair<const char*, Split> kLists[] = {
    {"test_filenames", Split::kTest}, {"val_filenames", Split::kValidation}, {"train_filenames", Split::kTraining}};

/// A picture for testing may also be listed for validation.
void read_lists(const JsonFields& json, std::vector<PosedPicture>& pictures, const std::string& where,
                const std::function<void(std::string_view)>& warn) {
  std::vector<SplitList> lists;
  std::set<std::string> listed;
  for (const auto& [key, split] : kLists) {
    SplitList& list = lists.emplace_back(SplitList{split, json.texts_or_none(key)});
    for (std::string& name : list.names) {
      std::replace(name.begin(), name.end(), '\\', '/');
      listed.insert(std::filesystem::path(name).lexically_normal().generic_string());
    }
  }
  if (listed.empty()) return;
  set_splits(lists, pictures, where, warn);
  std::vector<std::string> unlisted;
  for (const PosedPicture& picture : pictures)
    if (!listed.contains(std::filesystem::path(picture.picture).lexically_normal().generic_string()))
      unlisted.push_back(picture.picture);
  if (!unlisted.empty() && warn)
    warn(fmt::format("{}: these pictures count as training, because no list of file names has them: {}", where,
                     listed_names(unlisted)));
}

/// Lists the keys of the document and of its frames that are not supported.
void warn_of_other_keys(const Json& json, const std::string& where, const std::function<void(std::string_view)>& warn) {
  if (!warn) return;
  static const std::set<std::string_view> of_cameras{"w",  "h",  "fl_x", "fl_y", "cx", "cy", "camera_angle_x", "camera_angle_y",
                                                     "k1", "k2", "k3",   "k4",   "p1", "p2", "is_fisheye",     "camera_model"};
  static const std::set<std::string_view> of_document{"frames", "train_filenames", "val_filenames", "test_filenames", "depth"};
  static const std::set<std::string_view> of_frame{"file_path", "depth_file_path", "ray_length_file_path", "transform_matrix",
                                                   "time"};
  std::set<std::string> others, of_frames;
  for (const auto& [key, value] : json.items())
    if (!of_cameras.contains(key) && !of_document.contains(key)) others.insert(key);
  for (const Json& frame : json["frames"])
    for (const auto& [key, value] : frame.items())
      if (!of_cameras.contains(key) && !of_frame.contains(key)) of_frames.insert(key);
  std::string text = listed_names({others.begin(), others.end()});
  if (!of_frames.empty())
    text += (text.empty() ? "" : "; ") + ("of frames: " + listed_names({of_frames.begin(), of_frames.end()}));
  if (!text.empty()) warn(fmt::format("{}: left out: {}", where, text));
}

/// Adds the lists of pictures that nerfstudio reads. nerfstudio requires all three lists.
void write_lists(const std::vector<PosedPicture>& pictures, Json& json) {
  const auto add = [&](const char* key, Split split) {
    Json& names = json[key] = Json::array();
    for (const PosedPicture& picture : pictures)
      if (picture.split == split) names.push_back(picture.picture);
  };
  const bool has_validation =
      std::any_of(pictures.begin(), pictures.end(), [](const PosedPicture& p) { return p.split == Split::kValidation; });
  add("train_filenames", Split::kTraining);
  add("val_filenames", has_validation ? Split::kValidation : Split::kTest);
  add("test_filenames", Split::kTest);
}

bool same_intrinsics(const PosedCamera& a, const PosedCamera& b) {
  return a.size == b.size && a.focal_px == b.focal_px && a.principal_px == b.principal_px;
}

}  // namespace

std::vector<PosedPicture> parse_transforms(const std::string& text, const std::string& where,
                                           const std::function<void(std::string_view)>& warn) {
  constexpr std::size_t kMaxFrames = 65536;
  const Json json = json_from_text(text);
  if (json.is_discarded()) throw json_error(text, where);
  if (!json.is_object()) throw Error(where, "is not a JSON object", "an object with a list of frames");
  const JsonFields fields(json, where, "");
  const Json& frames = fields.value("frames");
  if (!frames.is_array() || frames.empty() || frames.size() > kMaxFrames)
    throw Error(where, frames.is_array() ? fmt::format("has {} frames", frames.size()) : "has no list of frames",
                fmt::format("frames, 1 to {}", kMaxFrames));
  PosedPicture common;
  common.camera.principal_px = Vec2d(std::numeric_limits<double>::quiet_NaN());
  read_intrinsics(fields, common);
  std::vector<PosedPicture> pictures;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string entry = fmt::format("frames[{}]", i);
    common.entry = fmt::format("{}: {}", where, entry);
    pictures.push_back(frame_from(JsonFields(frames[i], where, entry), common));
  }
  read_lists(fields, pictures, where, warn);
  warn_of_other_keys(json, where, warn);
  return pictures;
}

std::string transforms_text(const std::vector<PosedPicture>& pictures) {
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
  if (pictures.front().split) write_lists(pictures, json);
  json["frames"] = Json::array();
  for (const PosedPicture& picture : pictures) {
    Json frame{{"file_path", picture.picture}};
    if (!picture.depth.empty()) {
      frame["depth_file_path"] = picture.depth;
      frame["ray_length_file_path"] = ray_length_name(picture.depth);
    }
    if (picture.time) frame["time"] = *picture.time;
    if (!is_common) write_intrinsics(picture.camera, frame);
    frame["transform_matrix"] = matrix_of(picture.camera);
    json["frames"].push_back(std::move(frame));
  }
  return json_to_text(json) + '\n';
}

std::string split_transforms_text(const std::vector<PosedPicture>& pictures, Split split) {
  std::vector<PosedPicture> part = pictures_of_split(pictures, split);
  for (PosedPicture& picture : part)
    picture.picture = "./" + std::filesystem::path(picture.picture).replace_extension().generic_string();
  return part.empty() ? std::string() : transforms_text(part);
}

}  // namespace lippmann
