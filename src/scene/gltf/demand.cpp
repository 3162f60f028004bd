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
      : document_(document), nodes_(nodes), left_(document.limits.unpacked_bytes) {}

  void add_packed() {
    for (std::size_t i = 0; i < document_.packed_views.size(); ++i)
      if (const auto& view = document_.packed_views[i]) spend(view->count, view->byte_stride, element("bufferViews", i));
    for (const PrimitiveId id : all_primitives(document_)) add_draco(id);
  }

  void add_shown() {
    for (std::size_t i = 0; i < nodes_.file_node.size(); ++i)
      if (!nodes_.hidden[i]) add_node(nodes_.file_node[i]);
  }

  void add_keys(const std::string& wanted) {
    const Value animations = document_.root["animations"];
    if (animations.size() == 0) return;
    const Value animation = animations.at(wanted.empty() ? 0 : choose("animation", names_in(animations), wanted));
    const Value channels = animation["channels"];
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const int node = channels.at(i)["target"]["node"].index();
      if (node < 0 || nodes_.scene_node[static_cast<std::size_t>(node)] < 0) continue;
      const Value sampler = animation["samplers"].at(channels.at(i)["sampler"].count());
      add_floats(sampler["input"].index()), add_floats(sampler["output"].index());
    }
  }

 private:
  void spend(std::uint64_t count, std::uint64_t size, const std::string& where) {
    left_.spend(count, size, where, document_.report);
  }

  std::uint64_t count_of(int accessor) const { return document_.accessor(accessor).count; }

  /// Adds the unpacked size of an accessor. Each component is unpacked to a float or a 4-byte integer.
  void add_floats(int index) {
    if (index < 0) return;
    const Accessor& accessor = document_.accessor(index);
    spend(accessor.count, 4 * static_cast<std::uint64_t>(accessor.components),
          element("accessors", static_cast<std::size_t>(index)));
  }

  /// Adds the size of the Draco decoder's tables and of its output.
  void add_draco(PrimitiveId id) {
    const Value primitive = primitive_of(document_, id), packed = primitive.extension(kDraco);
    const int indices = primitive["indices"].index(), position = attribute(primitive, "POSITION");
    if (!packed || indices < 0 || position < 0) return;
    if (draco_views_.insert(packed["bufferView"].index()).second)
      spend(count_of(indices) / 3 + count_of(position), kDracoTableBytes, element(id));
    for (const auto& [name, unique_id] : packed["attributes"].index_map())
      if (const int index = attribute(primitive, name); index >= 0 && draco_accessors_.insert(index).second) add_floats(index);
  }

  void add_node(int file_node) {
    const Value node = document_.at("nodes", file_node);
    const int mesh = node["mesh"].index(), skin = node["skin"].index();
    if (mesh < 0) return;
    const std::uint64_t copies = add_copies(node, file_node);
    const Value primitives = document_.at("meshes", mesh)["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const PrimitiveId id{mesh, static_cast<int>(p)};
      const Value primitive = primitives.at(p);
      const int position = attribute(primitive, "POSITION");
      if (position < 0 || (mode_of(primitive) < Mode::kTriangles && !is_splats(primitive))) continue;
      if (shapes_.insert({id, is_splats(primitive) ? -1 : skin}).second) add_shape(id, skin >= 0);
      spend(copies, sizeof(Instance), element(id));
      const bool is_posed = skin >= 0 || primitive["targets"].size() > 0;
      if (is_posed) spend(copies * count_of(position), sizeof(PosedVertex), element(id));
    }
  }

  /// Adds the size of a node's copies (EXT_mesh_gpu_instancing). Returns how often the node shows its mesh.
  std::uint64_t add_copies(Value node, int file_node) {
    const Value instancing = node.extension(kInstancing);
    if (!instancing || node["skin"]) return 1;
    std::uint64_t copies = 0;
    for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"}) {
      const int index = instancing["attributes"][name].index();
      if (index < 0) continue;
      add_floats(index);
      copies = std::max(copies, count_of(index));
    }
    spend(copies, sizeof(Node), element("nodes", static_cast<std::size_t>(file_node)));
    return copies;
  }

  void add_shape(PrimitiveId id, bool is_skinned) {
    const Value primitive = primitive_of(document_, id);
    const auto add = [&](const std::string& name) { add_floats(attribute(primitive, name)); };
    if (is_splats(primitive)) {
      for (const auto& [name, index] : primitive["attributes"].index_map()) {
        add_floats(index);
        if (name.find(":SH_") != std::string::npos) add_floats(index);  // for the copy in Splats::harmonics
      }
      return;
    }
    for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"}) add(name);
    const int material = primitive["material"].index(), indices = primitive["indices"].index();
    if (material >= 0 && document_.at("materials", material)["normalTexture"]) add("TANGENT");
    const Value targets = primitive["targets"];
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (const auto& [name, index] : targets.at(i).index_map())
        if (name == "POSITION" || (name == "NORMAL" && attribute(primitive, "NORMAL") >= 0)) add_floats(index);
    for (int set = 0; is_skinned && attribute(primitive, fmt::format("JOINTS_{}", set)) >= 0; ++set) {
      for (int copy = 0; copy < 2; ++copy) add(fmt::format("JOINTS_{}", set)), add(fmt::format("WEIGHTS_{}", set));
    }
    spend(count_of(indices >= 0 ? indices : attribute(primitive, "POSITION")),
          sizeof(std::uint32_t) + sizeof(std::array<std::uint32_t, 3>), element(id));
  }

  const Document& document_;
  const NodeMap& nodes_;
  Budget left_;
  std::set<int> draco_views_, draco_accessors_;
  std::set<std::pair<PrimitiveId, int>> shapes_;
};

}  // namespace

void check_demand(const Document& document, const NodeMap& nodes, const std::string& animation) {
  Demand demand(document, nodes);
  demand.add_packed();
  demand.add_shown();
  demand.add_keys(animation);
}

}  // namespace lippmann::gltf
