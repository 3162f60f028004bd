#include "scene/gltf/demand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "scene/deform.hpp"
#include "scene/gltf/attribute.hpp"
#include "scene/gltf/choice.hpp"
#include "scene/gltf/draco.hpp"
#include "scene/gltf/instancing.hpp"
#include "scene/gltf/splats.hpp"

namespace lippmann::gltf {
namespace {

class Demand {
 public:
  Demand(const Document& document, const NodeMap& nodes)
      : document_(document), model_(document.model), nodes_(nodes), left_(document.limits.unpacked_bytes) {}

  void add_packed() {
    for (std::size_t i = 0; i < document_.packed_views.size(); ++i)
      if (const auto& view = document_.packed_views[i]) spend(view->count, view->byte_stride, element("bufferViews", i));
    for (std::size_t m = 0; m < model_.meshes.size(); ++m)
      for (std::size_t p = 0; p < model_.meshes[m].primitives.size(); ++p)
        add_draco({static_cast<int>(m), static_cast<int>(p)});
  }

  void add_shown() {
    for (std::size_t i = 0; i < nodes_.file_node.size(); ++i)
      if (!nodes_.hidden[i]) add_node(nodes_.file_node[i]);
  }

  void add_keys(const std::string& wanted) {
    if (model_.animations.empty()) return;
    std::vector<std::string> names;
    for (const tinygltf::Animation& animation : model_.animations) names.push_back(animation.name);
    const tinygltf::Animation& animation = model_.animations[wanted.empty() ? 0 : choose("animation", names, wanted)];
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      if (channel.target_node < 0 || nodes_.scene_node[static_cast<std::size_t>(channel.target_node)] < 0) continue;
      const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
      add_floats(sampler.input), add_floats(sampler.output);
    }
  }

 private:
  void spend(std::uint64_t count, std::uint64_t size, const std::string& where) {
    left_.spend(count, size, where, document_.report);
  }

  const tinygltf::Accessor& accessor(int index) const { return model_.accessors[static_cast<std::size_t>(index)]; }
  const tinygltf::Material& material(int index) const { return model_.materials[static_cast<std::size_t>(index)]; }
  std::uint64_t components(int index) const {
    return static_cast<std::uint64_t>(
        std::max(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor(index).type)), 1));
  }

  /// Elements become floats or integers of four bytes.
  void add_floats(int index) {
    if (index >= 0) spend(accessor(index).count, 4 * components(index), element("accessors", static_cast<std::size_t>(index)));
  }

  /// The decoder's tables, and the elements that it writes.
  void add_draco(PrimitiveId id) {
    const tinygltf::Primitive& primitive = primitive_of(document_, id);
    const auto found = primitive.extensions.find(kDraco);
    const int position = attribute(primitive, "POSITION");
    if (found == primitive.extensions.end() || primitive.indices < 0 || position < 0) return;
    const int view = found->second.Get("bufferView").GetNumberAsInt();
    if (draco_views_.insert(view).second)
      spend(accessor(primitive.indices).count / 3 + accessor(position).count, kDracoTableBytes, element(id));
    const tinygltf::Value& packed = found->second.Get("attributes");
    for (const std::string& name : packed.Keys())
      if (const int index = attribute(primitive, name); index >= 0 && draco_accessors_.insert(index).second) add_floats(index);
  }

  void add_node(int file_node) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(file_node)];
    if (node.mesh < 0) return;
    const std::uint64_t copies = add_copies(node, file_node);
    const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const PrimitiveId id{node.mesh, static_cast<int>(p)};
      const int position = attribute(mesh.primitives[p], "POSITION");
      if (position < 0 || (mesh.primitives[p].mode < TINYGLTF_MODE_TRIANGLES && !is_splats(mesh.primitives[p]))) continue;
      if (shapes_.insert({id, is_splats(mesh.primitives[p]) ? -1 : node.skin}).second) add_shape(id, node.skin >= 0);
      spend(copies, sizeof(Instance), element(id));
      const bool is_posed = node.skin >= 0 || !mesh.primitives[p].targets.empty();
      if (is_posed) spend(copies * accessor(position).count, sizeof(PosedVertex), element(id));
    }
  }

  /// How often the node shows its mesh.
  std::uint64_t add_copies(const tinygltf::Node& node, int file_node) {
    if (!is_instanced(node) || node.skin >= 0) return 1;
    std::uint64_t copies = 0;
    const tinygltf::Value& attributes = node.extensions.at("EXT_mesh_gpu_instancing").Get("attributes");
    for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"}) {
      if (!attributes.Has(name)) continue;
      const int index = attributes.Get(name).GetNumberAsInt();
      add_floats(index);
      copies = std::max<std::uint64_t>(copies, accessor(index).count);
    }
    spend(copies, sizeof(Node), element("nodes", static_cast<std::size_t>(file_node)));
    return copies;
  }

  void add_shape(PrimitiveId id, bool is_skinned) {
    const tinygltf::Primitive& primitive = primitive_of(document_, id);
    const auto add = [&](const std::string& name) { add_floats(attribute(primitive, name)); };
    if (is_splats(primitive)) {
      for (const auto& [name, index] : primitive.attributes) {
        add_floats(index);
        if (name.find(":SH_") != std::string::npos) add_floats(index);  // once more, in Splats::harmonics
      }
      return;
    }
    for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"}) add(name);
    const bool has_relief = primitive.material >= 0 && material(primitive.material).normalTexture.index >= 0;
    if (has_relief) add("TANGENT");
    for (const auto& target : primitive.targets)
      for (const auto& [name, index] : target)
        if (name == "POSITION" || (name == "NORMAL" && attribute(primitive, "NORMAL") >= 0)) add_floats(index);
    for (int set = 0; is_skinned && attribute(primitive, fmt::format("JOINTS_{}", set)) >= 0; ++set) {
      for (int copy = 0; copy < 2; ++copy)  // the second are SkinWeights
        add(fmt::format("JOINTS_{}", set)), add(fmt::format("WEIGHTS_{}", set));
    }
    const std::uint64_t corners = accessor(primitive.indices >= 0 ? primitive.indices : attribute(primitive, "POSITION")).count;
    spend(corners, sizeof(std::uint32_t) + sizeof(std::array<std::uint32_t, 3>), element(id));
  }

  const Document& document_;
  const tinygltf::Model& model_;
  const NodeMap& nodes_;
  Budget left_;
  std::set<int> draco_views_, draco_accessors_;
  std::set<std::pair<PrimitiveId, int>> shapes_;  ///< by primitive and skin
};

}  // namespace

void refuse_excess(const Document& document, const NodeMap& nodes, const std::string& animation) {
  Demand demand(document, nodes);
  demand.add_packed();
  demand.add_shown();
  demand.add_keys(animation);
}

}  // namespace lippmann::gltf
