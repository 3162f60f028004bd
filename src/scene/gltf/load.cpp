// Puts the parts of a glTF file together into a Scene.
#include "scene/gltf.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "scene/gltf/animation.hpp"
#include "scene/gltf/camera.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/light.hpp"
#include "scene/gltf/material.hpp"
#include "scene/gltf/mesh.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/gltf/skin.hpp"

namespace lippmann {
namespace gltf {
namespace {

/// Makes the Scene's shapes and instances; a primitive that several nodes show is one shape.
class InstanceReader {
 public:
  InstanceReader(Document& document, const NodeMap& nodes, Scene& scene)
      : document_(document),
        nodes_(nodes),
        scene_(scene),
        materials_(read_materials(document, scene)),
        rest_(evaluate(scene, 0.0)) {}

  void read() {
    for (std::size_t i = 0; i < nodes_.file_node.size(); ++i) {
      const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(nodes_.file_node[i])];
      if (node.mesh >= 0) add(node, nodes_.file_node[i], static_cast<int>(i));
    }
  }

 private:
  void add(const tinygltf::Node& node, int file_node, int scene_node) {
    const tinygltf::Mesh& mesh = document_.model.meshes[static_cast<std::size_t>(node.mesh)];
    if (node.skin >= 0)
      document_.report.not_supported("skinning is", "the mesh stands in its rest pose",
                                     element("nodes", static_cast<std::size_t>(file_node)));
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
      Instance instance;
      const PrimitiveId id{node.mesh, static_cast<int>(i)};
      instance.material = material_of(mesh.primitives[i].material, materials_, scene_);
      instance.shape = shape_of(id, node.skin, materials_.needs[static_cast<std::size_t>(instance.material)]);
      instance.node = node.skin < 0 ? scene_node : -1;  // a skinned mesh stands in world space
      instance.name = node.name.empty() ? mesh.name : node.name;
      if (instance.shape < 0) continue;
      document_.unpacked.spend(1, sizeof(Instance) + instance.name.size(), element(id), document_.report);
      scene_.instances.push_back(std::move(instance));
    }
  }

  /// -1: nothing to show.
  int shape_of(PrimitiveId id, int skin, const MaterialNeeds& needs) {
    const auto [known, is_new] = shapes_.try_emplace({id, skin}, -1);
    if (!is_new) return known->second;
    std::optional<Mesh> mesh = read_mesh(document_, id, needs);
    if (!mesh) return -1;
    if (skin >= 0) pose_at_rest(document_, id, skin, nodes_, rest_, *mesh);
    known->second = static_cast<int>(scene_.shapes.size());
    scene_.shapes.emplace_back(std::move(*mesh));
    return known->second;
  }

  Document& document_;
  const NodeMap& nodes_;
  Scene& scene_;
  MaterialTable materials_;
  ResolvedScene rest_;                                 ///< the timeline is still empty
  std::map<std::pair<PrimitiveId, int>, int> shapes_;  ///< by primitive and skin
};

void refuse_infinite_transforms(const Document& document, const NodeMap& nodes, const Scene& scene) {
  const ResolvedScene rest = evaluate(scene, 0.0);
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const Affine3f& a = rest.world_from_node[i];
    const float sum = glm::dot(a.linear[0] + a.linear[1] + a.linear[2] + a.translation, Vec3f(1.0f));
    if (!std::isfinite(sum))
      document.report.fail(element("nodes", static_cast<std::size_t>(nodes.file_node[i])),
                           "stands or reaches infinitely far away");
  }
}

}  // namespace
}  // namespace gltf

Scene parse_gltf(std::vector<std::byte> contents, const std::filesystem::path& path, double frames_per_second,
                 const Context& context, const GltfLimits& limits) {
  if (!(frames_per_second > 0.0) || !std::isfinite(frames_per_second))
    throw usage_error("frames per second", fmt::format("is {}", frames_per_second), "a number above 0");
  gltf::Document document(path, context, limits);
  gltf::read_document(std::move(contents), document);

  Scene scene;
  scene.name = path.stem().string();
  const gltf::NodeMap nodes = gltf::read_nodes(document, scene);
  gltf::refuse_infinite_transforms(document, nodes, scene);
  gltf::InstanceReader(document, nodes, scene).read();
  gltf::read_lights(document, nodes, scene);
  gltf::read_cameras(document, nodes, scene);
  gltf::add_default_light(document, scene);
  gltf::read_animation(document, nodes, frames_per_second, scene);
  return scene;
}

Scene load_gltf(const std::filesystem::path& path, double frames_per_second, const Context& context, const GltfLimits& limits) {
  const gltf::Report report(path.string(), context);
  return parse_gltf(gltf::read_file(path, limits.file_bytes, {}, report), path, frames_per_second, context, limits);
}

}  // namespace lippmann
