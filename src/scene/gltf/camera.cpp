#include "scene/gltf/camera.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "lippmann/scene/timeline.hpp"

namespace lippmann::gltf {
namespace {

Camera read_perspective(Value from) {
  Camera camera;
  camera.vertical_fov = static_cast<float>(from["yfov"].number(0.0));
  camera.aspect = static_cast<float>(from["aspectRatio"].number(0.0));
  return camera;
}

/// Returns the distance from a node to the scene's centre along the node's -z, in the node's units, or `otherwise` if the
/// centre is behind the node.
float distance_to_centre(const Affine3f& node_from_world, const Bounds3f& bounds, float otherwise) {
  if (bounds.empty()) return otherwise;
  const float distance = -transform_point(node_from_world, bounds.center()).z;
  return distance > 0.0f && std::isfinite(distance) ? distance : otherwise;
}

/// Returns half the height, in the node's units, of a view that shows the whole scene from any direction.
float half_extent(const Affine3f& node_from_world, const Bounds3f& bounds) {
  if (bounds.empty()) return 1.0f;
  const float half = 0.5f * glm::length(transform_vector(node_from_world, bounds.upper - bounds.lower));
  return half > 0.0f && std::isfinite(half) ? half : 1.0f;
}

bool shows_nothing(Value orthographic) {
  return orthographic["xmag"].number(0.0) == 0.0 || orthographic["ymag"].number(0.0) == 0.0;
}

/// vertical_fov is chosen so that a perspective camera would show the same height at the scene's centre.
Camera read_orthographic(Value from, int node, const Scene& scene) {
  const ResolvedScene rest = evaluate(scene, 0.0);
  const Bounds3f bounds = finite_bounds(scene, rest);
  const Affine3f node_from_world = inverse(rest.of(node));
  const bool is_empty = shows_nothing(from);
  const float half_height =
      is_empty ? half_extent(node_from_world, bounds) : std::abs(static_cast<float>(from["ymag"].number(0.0)));
  const float half_width = std::abs(static_cast<float>(from["xmag"].number(0.0)));
  const float middle = static_cast<float>(0.5 * (from["znear"].number(0.0) + from["zfar"].number(0.0)));
  const float distance = distance_to_centre(node_from_world, bounds, std::max(middle, half_height));
  constexpr float kNarrowest = 1e-3f, kWidest = 3.0f;
  Camera camera;
  camera.vertical_fov = std::clamp(2.0f * std::atan2(half_height, distance), kNarrowest, kWidest);
  camera.orthographic_height = 2.0f * half_height;
  camera.aspect = !is_empty && std::isfinite(half_width / half_height) ? half_width / half_height : 0.0f;
  return camera;
}

}  // namespace

void read_cameras(Document& document, const NodeMap& nodes, Scene& scene) {
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const int index = document.at("nodes", nodes.file_node[i])["camera"].index();
    if (index < 0) continue;
    const Value from = document.at("cameras", index);
    const std::string& type = from["type"].text();
    const std::string where = element("cameras", static_cast<std::size_t>(index));
    const Value shape = from[type];
    if (!shape) document.report.fail(fmt::format("{}.{}", where, type), "is missing");
    const int node = static_cast<int>(i);
    const bool perspective = type == "perspective";
    if (!perspective && shows_nothing(shape))
      document.report.warn_at("orthographic cameras with an xmag or ymag of 0 are enlarged to show the whole scene", where);
    Camera camera = perspective ? read_perspective(shape) : read_orthographic(shape, node, scene);
    camera.name = !from["name"].text().empty() ? from["name"].text() : scene.nodes[i].name;
    camera.near_distance = std::max(static_cast<float>(shape["znear"].number(0.0)), 0.0f);
    const Value extras = from["extras"];
    camera.shift = Vec2f(extras["shift_x"].number(0.0), extras["shift_y"].number(0.0));
    camera.node = node;
    scene.cameras.push_back(std::move(camera));
  }
}

}  // namespace lippmann::gltf
