#include "scene/gltf/camera.hpp"

#include <algorithm>
#include <cmath>

#include "lippmann/scene/timeline.hpp"

namespace lippmann::gltf {
namespace {

Camera read_perspective(const tinygltf::PerspectiveCamera& from) {
  Camera camera;
  camera.vertical_fov = static_cast<float>(from.yfov);
  camera.aspect = static_cast<float>(from.aspectRatio);
  return camera;
}

/// How far in front of a node, in its own units, the scene's centre is; `otherwise` where it is not in front.
float distance_to_centre(const Affine3f& node_from_world, const Bounds3f& bounds, float otherwise) {
  if (bounds.empty()) return otherwise;
  const float distance = -transform_point(node_from_world, bounds.center()).z;
  return distance > 0.0f && std::isfinite(distance) ? distance : otherwise;
}

/// Half the height, in a node's own units, that shows the scene from every side.
float half_extent(const Affine3f& node_from_world, const Bounds3f& bounds) {
  if (bounds.empty()) return 1.0f;
  const float half = 0.5f * glm::length(transform_vector(node_from_world, bounds.upper - bounds.lower));
  return half > 0.0f && std::isfinite(half) ? half : 1.0f;
}

/// Its angle is that of a perspective camera that shows the same height at the scene's centre, for whoever wants an angle.
Camera read_orthographic(const tinygltf::OrthographicCamera& from, int node, const Scene& scene) {
  const ResolvedScene rest = evaluate(scene, 0.0);
  const Bounds3f bounds = finite_bounds(scene, rest);
  const Affine3f node_from_world = inverse(rest.of(node));
  const bool is_empty = from.xmag == 0.0 || from.ymag == 0.0;
  const float half_height = is_empty ? half_extent(node_from_world, bounds) : std::abs(static_cast<float>(from.ymag));
  const float half_width = std::abs(static_cast<float>(from.xmag));
  const float middle = static_cast<float>(0.5 * (from.znear + from.zfar));
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
    const int index = document.model.nodes[static_cast<std::size_t>(nodes.file_node[i])].camera;
    if (index < 0) continue;
    const tinygltf::Camera& from = document.model.cameras[static_cast<std::size_t>(index)];
    const int node = static_cast<int>(i);
    const bool perspective = from.type == "perspective";
    if (!perspective && (from.orthographic.xmag == 0.0 || from.orthographic.ymag == 0.0))
      document.report.warn_at("orthographic cameras whose xmag or ymag is 0 would show nothing: they show the whole scene",
                              element("cameras", static_cast<std::size_t>(index)));
    Camera camera = perspective ? read_perspective(from.perspective) : read_orthographic(from.orthographic, node, scene);
    camera.name = !from.name.empty() ? from.name : scene.nodes[i].name;
    camera.node = node;
    scene.cameras.push_back(std::move(camera));
  }
}

}  // namespace lippmann::gltf
