#include "scene/gltf.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/origin.hpp"
#include "scene/deform.hpp"
#include "scene/gltf/animation.hpp"
#include "scene/gltf/camera.hpp"
#include "scene/gltf/demand.hpp"
#include "scene/gltf/document.hpp"
#include "scene/gltf/ies_light.hpp"
#include "scene/gltf/image_light.hpp"
#include "scene/gltf/instancing.hpp"
#include "scene/gltf/light.hpp"
#include "scene/gltf/material.hpp"
#include "scene/gltf/mesh.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/gltf/skin.hpp"
#include "scene/gltf/splats.hpp"
#include "scene/gltf/variants.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace gltf {
namespace {

void check_finite(const Affine3f& a, int file_node, const Report& report) {
  const float sum = glm::dot(a.linear[0] + a.linear[1] + a.linear[2] + a.translation, Vec3f(1.0f));
  if (!std::isfinite(sum))
    report.fail(element("nodes", static_cast<std::size_t>(file_node)), "has a world transform that is not finite");
}

/// Creates the Scene's shapes and instances. Nodes with the same primitive share a shape.
class InstanceReader {
 public:
  InstanceReader(Document& document, const NodeMap& nodes, int variant, Scene& scene)
      : document_(document),
        nodes_(nodes),
        variant_(variant),
        scene_(scene),
        materials_(read_materials(document, scene)),
        skins_(document, nodes, scene) {}

  void read() {
    for (std::size_t i = 0; i < nodes_.file_node.size(); ++i)
      scene_.nodes[i].morph_weights = read_morph_weights(document_, nodes_.file_node[i]);
    std::map<int, std::vector<int>> places;
    bool any_hidden = false;
    for (std::size_t i = 0; i < nodes_.file_node.size(); ++i) {
      const int file_node = nodes_.file_node[i];
      if (!node_at(file_node)["mesh"]) continue;
      if (nodes_.hidden[i])
        any_hidden = true;
      else
        places[static_cast<int>(i)] = places_of(file_node, static_cast<int>(i));
    }
    if (places.empty() && any_hidden) document_.report.warn("all nodes with a mesh are invisible (KHR_node_visibility)");
    rest_ = evaluate(scene_, 0.0);
    for (const auto& [node, copies] : places) add(nodes_.file_node[static_cast<std::size_t>(node)], copies);
  }

 private:
  Value node_at(int file_node) const { return document_.at("nodes", file_node); }

  /// Returns the Scene nodes that show the mesh of a node: the node itself, or its copies (EXT_mesh_gpu_instancing).
  std::vector<int> places_of(int file_node, int scene_node) {
    if (!node_at(file_node).extension(kInstancing)) return {scene_node};
    if (!node_at(file_node)["skin"]) return read_places(document_, file_node, scene_node, scene_);
    document_.report.warn_at("copies of skinned meshes are left out: they would coincide",
                             element("nodes", static_cast<std::size_t>(file_node)));
    return {scene_node};
  }

  void add(int file_node, const std::vector<int>& places) {
    const Value node = node_at(file_node);
    for (const int place : places) check_finite(rest_.of(place), file_node, document_.report);
    const Value mesh = document_.at("meshes", node["mesh"].index()), primitives = mesh["primitives"];
    const std::string& name = node["name"].text().empty() ? mesh["name"].text() : node["name"].text();
    const int skin = node["skin"] ? skins_.read(node["skin"].index()) : -1;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      Instance instance;
      const PrimitiveId id{node["mesh"].index(), static_cast<int>(i)};
      if (is_splats(primitives.at(i))) {
        instance.shape = splats_of(id, skin);
        instance.material = material_of_splats_;
      } else {
        instance.material =
            material_of(material_in(primitives.at(i), variant_, element(id), document_.report), materials_, scene_);
        instance.shape = shape_of(id, skin, materials_.needs[static_cast<std::size_t>(instance.material)]);
        instance.skin = skin;
        instance.hidden_from_cameras = !node["extras"]["visible_to_camera"].flag(true);
        instance.casts_no_shadow = !node["extras"]["casts_shadow"].flag(true);
      }
      instance.name = name;
      if (instance.shape < 0) continue;
      document_.unpacked.spend(places.size(), sizeof(Instance) + instance.name.size(), element(id), document_.report);
      for (const int place : places) {
        instance.node = place;
        if (is_posed(scene_, instance)) check_pose(instance, id);
        scene_.instances.push_back(instance);
      }
    }
  }

  /// Checks the memory and the positions of the deformed mesh of an instance. A deformed mesh needs its own vertices at every
  /// node that shows it.
  void check_pose(const Instance& instance, PrimitiveId id) {
    const std::size_t vertices = std::get<Mesh>(scene_.shapes[static_cast<std::size_t>(instance.shape)]).positions.size();
    document_.unpacked.spend(vertices, sizeof(PosedVertex), element(id), document_.report);
    const MeshPose pose(scene_, instance, rest_);
    for (std::size_t i = 0; i < vertices; ++i)
      if (const Vec3f p = glm::abs(pose.position(i)); std::max({p.x, p.y, p.z}) >= MeshPose::kReach)
        document_.report.fail(element(id), fmt::format("skinning or morphing moves vertex {} too far away", i));
  }

  int shape_of(PrimitiveId id, int skin, const MaterialNeeds& needs) {
    const auto [known, is_new] = shapes_.try_emplace({id, skin}, -1);
    if (!is_new) return known->second;
    std::optional<Mesh> mesh = read_mesh(document_, id, needs);
    if (!mesh) return -1;
    if (skin >= 0) read_skin_weights(document_, id, scene_.skins[static_cast<std::size_t>(skin)].joints.size(), *mesh);
    known->second = static_cast<int>(scene_.shapes.size());
    scene_.shapes.emplace_back(std::move(*mesh));
    return known->second;
  }

  int splats_of(PrimitiveId id, int skin) {
    const auto [known, is_new] = shapes_.try_emplace({id, -1}, -1);
    if (!is_new) return known->second;
    if (skin >= 0) document_.report.warn_at("skins of splats are ignored", element(id));
    std::optional<Splats> splats = read_splats(document_, id);
    if (!splats) return -1;
    if (material_of_splats_ < 0) {
      material_of_splats_ = static_cast<int>(scene_.materials.size());
      scene_.materials.push_back(splat_material());
      materials_.needs.emplace_back();
    }
    known->second = static_cast<int>(scene_.shapes.size());
    scene_.shapes.emplace_back(std::move(*splats));
    return known->second;
  }

  Document& document_;
  const NodeMap& nodes_;
  int variant_;
  int material_of_splats_ = -1;
  Scene& scene_;
  MaterialTable materials_;
  SkinReader skins_;
  ResolvedScene rest_;
  std::map<std::pair<PrimitiveId, int>, int> shapes_;
};

void check_transforms(const Document& document, const NodeMap& nodes, const Scene& scene) {
  const ResolvedScene rest = evaluate(scene, 0.0);
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i)
    check_finite(rest.world_from_node[i], nodes.file_node[i], document.report);
}

}  // namespace
}  // namespace gltf

Scene parse_gltf(std::vector<std::byte> contents, const std::filesystem::path& path, const LoadOptions& options,
                 const Context& context, const GltfLimits& limits) {
  if (!(options.frames_per_second >= 0.0) || !std::isfinite(options.frames_per_second))
    throw usage_error("frames per second", fmt::format("is {}", options.frames_per_second),
                      "a number above 0, or 0 for the rate of the keyframes");
  gltf::Document document(path, options, context, limits);
  gltf::read_document(std::move(contents), document);

  Scene scene;
  scene.name = path.stem().string();
  if (gltf::is_of_splats_alone(*document.json)) scene.kind = SceneKind::kSplats;
  const gltf::NodeMap nodes = gltf::read_nodes(document, scene);
  gltf::check_transforms(document, nodes, scene);
  gltf::check_demand(document, nodes, options.animation);
  gltf::unpack_document(document);
  scene.variant_names = gltf::variant_names(document);
  gltf::InstanceReader(document, nodes, gltf::choose_variant(scene.variant_names, options.variant), scene).read();
  gltf::read_lights(document, nodes, scene);
  gltf::read_ies_lights(document, nodes, scene);
  gltf::read_image_light(document, scene);
  gltf::read_cameras(document, nodes, scene);
  gltf::read_animation(document, nodes, options.animation, options.frames_per_second, scene);
  if (const std::optional<Vec3d> origin = distant_origin(scene)) move_origin(scene, *origin, nodes.parent_from_node);
  return scene;
}

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context,
                const GltfLimits& limits) {
  const gltf::Report report(path.string(), context);
  return parse_gltf(gltf::read_file(path, limits.file_bytes, {}, report), path, options, context, limits);
}

}  // namespace lippmann
