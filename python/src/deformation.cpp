// Binds the deformation of meshes by morph targets, which are blended by weights, and by skins, which follow joints.
//
// In a lippmann.Scene, each mesh shape has exactly one instance and one node, so the index of the shape identifies all three.
#include <algorithm>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann::python {
namespace {

Mesh& mesh_of(Scene& scene, int shape) { return std::get<Mesh>(scene.shapes.at(static_cast<std::size_t>(shape))); }

Instance& instance_of(Scene& scene, int shape) {
  return *std::find_if(scene.instances.begin(), scene.instances.end(), [&](const Instance& i) { return i.shape == shape; });
}

std::vector<Vec3f> offsets_of(const Array<float>& array, py::ssize_t index) {
  std::vector<Vec3f> offsets;
  const float* data = array.data(index);
  for (py::ssize_t v = 0; v < array.shape(1); ++v, data += 3) offsets.emplace_back(data[0], data[1], data[2]);
  return offsets;
}

/// positions and normals: offsets (n, vertices, 3). weights: factors of the n targets in frames without animation.
void set_targets(Scene& scene, int shape, const Array<float>& positions, const std::optional<Array<float>>& normals,
                 std::vector<float> weights) {
  Mesh& mesh = mesh_of(scene, shape);
  const auto vertices = static_cast<py::ssize_t>(mesh.positions.size());
  require_shape(positions, {static_cast<py::ssize_t>(weights.size()), vertices, 3}, "targets");
  if (normals) require_shape(*normals, {positions.shape(0), vertices, 3}, "target_normals");
  for (py::ssize_t t = 0; t < positions.shape(0); ++t) {
    MorphTarget target{offsets_of(positions, t), {}, {}};
    if (normals) target.normals = offsets_of(*normals, t);
    mesh.targets.push_back(std::move(target));
  }
  scene.nodes[static_cast<std::size_t>(instance_of(scene, shape).node)].morph_weights = std::move(weights);
}

ResolvedScene at_rest(const Scene& scene) {
  Scene skeleton;
  skeleton.nodes = scene.nodes;
  return evaluate(skeleton, 0.0);
}

/// Sets the skin of a mesh. The current transforms of the joints are the rest pose. joints: nodes. indices: (vertices, n)
/// indices into `joints`. weights: (vertices, n).
void set_skin(Scene& scene, int shape, const std::vector<int>& joints, const Array<std::uint32_t>& indices,
              const Array<float>& weights) {
  Mesh& mesh = mesh_of(scene, shape);
  require_shape(indices, {static_cast<py::ssize_t>(mesh.positions.size()), -1}, "skin.indices");
  require_shape(weights, {indices.shape(0), indices.shape(1)}, "skin.weights");
  mesh.skin.per_vertex = static_cast<int>(indices.shape(1));
  mesh.skin.joints.assign(indices.data(), indices.data() + indices.size());
  mesh.skin.weights.assign(weights.data(), weights.data() + weights.size());
  Instance& instance = instance_of(scene, shape);
  const ResolvedScene rest = at_rest(scene);
  Skin skin{instance.name, joints, {}};
  for (const int joint : joints) skin.joint_from_mesh.push_back(inverse(rest.of(joint)) * rest.of(instance.node));
  instance.skin = static_cast<int>(scene.skins.size());
  scene.skins.push_back(std::move(skin));
}

}  // namespace

void bind_deformation(py::module_& module) {
  module.def("set_targets", &set_targets);
  module.def("set_skin", &set_skin);
}

}  // namespace lippmann::python
