#include "scene/tachyon/camera.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/directions.hpp"
#include "scene/tachyon/handedness.hpp"
#include "scene/tachyon/scene_builder.hpp"

namespace lippmann::tachyon {
namespace {

float positive_number(Lexer& lexer, std::string_view keyword) {
  const float value = lexer.number(keyword);
  if (!(value > 0.0f)) throw lexer.error(fmt::format("{} is {}", keyword, value), "a number above 0");
  return value;
}

void parse_projection(Lexer& lexer, CameraRecord& record, const Context& context) {
  std::string word = upper(lexer.word("PROJECTION or ZOOM"));
  if (word == "PROJECTION") word = upper(lexer.word("PROJECTION's name"));
  if (word == "ZOOM") return;
  record.is_orthographic = word == "ORTHOGRAPHIC";
  if (word == "PERSPECTIVE_DOF") {
    const std::string where = lexer.where();
    if (const std::string distance = upper(lexer.word("FOCALDIST")); distance != "FOCALDIST" && distance != "FOCALLENGTH")
      throw lexer.error(fmt::format("expected FOCALDIST, found {}", shown(distance)), "FOCALDIST, FOCALLENGTH");
    positive_number(lexer, "FOCALDIST");
    lexer.expect("APERTURE");
    positive_number(lexer, "APERTURE");
    context.warning(fmt::format("{}: the depth of field of PERSPECTIVE_DOF is left out.", where));
  } else if (word != "PERSPECTIVE" && !record.is_orthographic) {
    throw lexer.error(fmt::format("the projection {} is not supported", shown(word)),
                      "PERSPECTIVE, PERSPECTIVE_DOF, ORTHOGRAPHIC");
  }
  lexer.expect("ZOOM");
}

/// Reads "FRUSTUM left right bottom top", which are distances in the image plane at distance 1.
Vec2f parse_frustum(Lexer& lexer) {
  const float left = lexer.number("FRUSTUM"), right = lexer.number("FRUSTUM");
  const float bottom = lexer.number("FRUSTUM"), top = lexer.number("FRUSTUM");
  if (!(right > 0.0f && top > 0.0f && left == -right && bottom == -top))
    throw lexer.error("only a symmetric FRUSTUM is supported", "left = -right < 0 and bottom = -top < 0");
  return {right, top};
}

}  // namespace

CameraRecord parse_camera(Lexer& lexer, const Context& context) {
  constexpr int kMostSamples = 1'000'000, kDeepest = 1'000'000;
  CameraRecord record;
  parse_projection(lexer, record, context);
  record.zoom = positive_number(lexer, "ZOOM");
  lexer.expect("ASPECTRATIO");
  record.aspect_ratio = positive_number(lexer, "ASPECTRATIO");
  if (record.aspect_ratio != 1.0f)
    context.warning(fmt::format("{}: ASPECTRATIO {} means non-square pixels, which are rendered square.", lexer.where(),
                                record.aspect_ratio));
  lexer.expect("ANTIALIASING");
  const int extra_samples = lexer.integer("ANTIALIASING", 0, kMostSamples);
  if (extra_samples > 0)
    context.warning(
        fmt::format("{}: ANTIALIASING {} is ignored; the render's samples per pixel apply.", lexer.where(), extra_samples));
  lexer.expect("RAYDEPTH");
  record.ray_depth = lexer.integer("RAYDEPTH", 0, kDeepest);
  record.pose.center = lexer.point_after("CENTER");
  record.pose.view = lexer.vector_after("VIEWDIR");
  record.pose.up = lexer.vector_after("UPDIR");
  require_orientation(record.pose, lexer);
  const std::string_view word = lexer.word("END_CAMERA");
  if (is_keyword(word, "FRUSTUM")) {
    record.half_extent = parse_frustum(lexer);
    lexer.expect("END_CAMERA");
  } else if (!is_keyword(word, "END_CAMERA")) {
    throw lexer.error(fmt::format("expected END_CAMERA, found {}", shown(word)), "FRUSTUM, END_CAMERA");
  }
  return record;
}

void require_orientation(const CameraPose& pose, const Lexer& lexer) {
  const glm::dvec3 view(pose.view), up(pose.up), right = glm::cross(up, view);
  // Smallest accepted sine of the angle between the view and up directions. Below it, the result depends on the rounding of
  // digits.
  constexpr double kSine = 1e-6;
  if (glm::length(right) > kSine * glm::length(up) * glm::length(view)) return;
  throw lexer.error("the camera's view and up directions do not span a plane", "two non-zero vectors that are not parallel");
}

Transform node_of(const CameraPose& pose) {
  Transform transform;
  transform.translation = mirrored(pose.center);
  transform.rotation = looking_along(mirrored(pose.view), mirrored(pose.up));
  return transform;
}

Camera camera_of(const CameraRecord& record, Vec2i resolution) {
  const double half_height = record.half_extent ? record.half_extent->y : 0.5 / record.zoom;
  Camera camera;
  camera.name = "camera";
  camera.vertical_fov = static_cast<float>(2.0 * std::atan(half_height));
  if (record.is_orthographic) camera.orthographic_height = static_cast<float>(2.0 * half_height);
  camera.aspect = record.half_extent
                      ? record.half_extent->x / record.half_extent->y
                      : static_cast<float>(resolution.x) / static_cast<float>(resolution.y) / record.aspect_ratio;
  camera.pixel_offset = {0.5f, -0.5f};
  return camera;
}

}  // namespace lippmann::tachyon
