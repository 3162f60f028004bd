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
float distance_to_centre(const Scene& scene, int node, float otherwise) {
  const ResolvedScene rest = evaluate(scene, 0.0);
  const Bounds3f bounds = finite_bounds(scene, rest);
  if (bounds.empty()) return otherwise;
  const float distance = -transform_point(inverse(rest.of(node)), bounds.center()).z;
  return distance > 0.0f && std::isfinite(distance) ? distance : otherwise;
}

/// Its angle is that of a perspective camera that shows the same height at the scene's centre, for whoever wants an angle.
Camera read_orthographic(const tinygltf::OrthographicCamera& from, int node, const Scene& scene) {
  const float half_height = std::abs(static_cast<float>(from.ymag)), half_width = std::abs(static_cast<float>(from.xmag));
  const float middle = static_cast<float>(0.5 * (from.znear + from.zfar));
  const float distance = distance_to_centre(scene, node, std::max(middle, half_height));
  constexpr float kNarrowest = 1e-3f, kWidest = 3.0f;
  Camera camera;
  camera.vertical_fov = std::clamp(2.0f * std::atan2(half_height, distance), kNarrowest, kWidest);
  camera.orthographic_height = 2.0f * half_height;
  camera.aspect = half_height > 0.0f && std::isfinite(half_width / half_height) ? half_width / half_height : 0.0f;
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
    Camera camera = perspective ? read_perspective(from.perspective) : read_orthographic(from.orthographic, node, scene);
    camera.name = !from.name.empty() ? from.name : scene.nodes[i].name;
    camera.node = node;
    scene.cameras.push_back(std::move(camera));
  }
}

}  // namespace lippmann::gltf
