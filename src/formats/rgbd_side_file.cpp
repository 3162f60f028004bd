#include "formats/rgbd_side_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr NumberRange kLength{1e-6, 1e9};

Json rgbd_document(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  Json json = json_from_text(read_recorded_text(path, kMaxBytes, "the side file of an RGB-D picture"));
  if (json.is_discarded())
    throw Error(path.string(), "is not JSON", "the JSON side file of a quilt or an RGB-D picture, or no file of that name");
  return json;
}

/// The quantity in which grey is linear: z, or the disparity.
double scale_of(const DepthCoding& coding, double distance_mm, double z_mm) {
  return coding.even_in_depth ? z_mm : disparity_of_depth(z_mm, distance_mm);
}

}  // namespace

double disparity_of_depth(double z_mm, double distance_mm) {
  return std::isinf(z_mm) ? -distance_mm : z_mm / (1.0 - z_mm / distance_mm);
}

double depth_of_disparity(double q_mm, double distance_mm) {
  const double share = 1.0 + q_mm / distance_mm;
  return share > 0.0 ? q_mm / share : -INFINITY;
}

double grey_of_depth(const DepthCoding& coding, double distance_mm, double z_mm) {
  const double far = scale_of(coding, distance_mm, coding.range.far_mm),
               near = scale_of(coding, distance_mm, coding.range.near_mm);
  const double grey = std::clamp((scale_of(coding, distance_mm, z_mm) - far) / (near - far), 0.0, 1.0);
  return coding.near_black ? 1.0 - grey : grey;
}

double depth_of_grey(const DepthCoding& coding, double distance_mm, double grey) {
  const double far = scale_of(coding, distance_mm, coding.range.far_mm),
               near = scale_of(coding, distance_mm, coding.range.near_mm);
  const double value = far + (coding.near_black ? 1.0 - grey : grey) * (near - far);
  return coding.even_in_depth ? value : depth_of_disparity(value, distance_mm);
}

DepthRange range_before_eye(DepthRange range, double distance_mm) {
  const double least = 1e-3 * distance_mm;
  range.near_mm = std::min(range.near_mm, 0.99 * distance_mm);
  range.far_mm = std::clamp(range.far_mm, -1e9, range.near_mm);
  if (range.near_mm - range.far_mm < least) range.near_mm += 0.5 * least, range.far_mm -= 0.5 * least;
  return range;
}

fs::path rgbd_side_path(const fs::path& image) { return fs::path(image) += ".json"; }

std::optional<RgbdSideFile> read_rgbd_side_file(const fs::path& image) {
  const fs::path path = rgbd_side_path(image);
  if (!is_regular_file_there(path)) return std::nullopt;
  const Json json = rgbd_document(path);
  if (!json.is_object() || !json.contains("rgbd")) return std::nullopt;
  const JsonFields rgbd = JsonFields(json, path.string(), "").inner("rgbd");
  rgbd.allow_only({"depth_at", "linear_in", "white", "near_mm", "far_mm", "distance_mm", "size_mm", "eye_mm"});
  RgbdSideFile side;
  side.distance_mm = rgbd.number("distance_mm", kLength);
  const std::vector<double> size = rgbd.numbers("size_mm", 2, kLength), eye = rgbd.numbers("eye_mm", 2);
  side.size_mm = {size[0], size[1]}, side.eye_mm = {eye[0], eye[1]};
  side.coding.range.near_mm = rgbd.number("near_mm", {-1e9, 0.999 * side.distance_mm});
  side.coding.range.far_mm = rgbd.number("far_mm", {-1e9, 1e9});
  if (!(side.coding.range.far_mm < side.coding.range.near_mm)) rgbd.reject("far_mm", "is not behind near_mm", "a lower depth");
  side.coding.even_in_depth = rgbd.word("linear_in", {"disparity", "depth"}) == 1;
  side.coding.near_black = rgbd.word("white", {"near", "far"}) == 1;
  rgbd.word_or("depth_at", {"right"}, 0);
  return side;
}

void write_rgbd_side_file(const fs::path& image, const RgbdSideFile& side) {
  const DepthCoding& coding = side.coding;
  const Json json{{"rgbd",
                   {{"depth_at", "right"},
                    {"linear_in", coding.even_in_depth ? "depth" : "disparity"},
                    {"white", coding.near_black ? "far" : "near"},
                    {"near_mm", coding.range.near_mm},
                    {"far_mm", coding.range.far_mm},
                    {"distance_mm", side.distance_mm},
                    {"size_mm", {side.size_mm.x, side.size_mm.y}},
                    {"eye_mm", {side.eye_mm.x, side.eye_mm.y}}}}};
  const std::string text = json_to_text(json) + '\n';
  write_file_atomically(rgbd_side_path(image), std::as_bytes(std::span(text)));
}

}  // namespace lippmann
