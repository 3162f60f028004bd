#include "scene/gltf/check_indices.hpp"

#include <fmt/format.h>

namespace lippmann::gltf {
namespace {

class IndexChecker {
 public:
  explicit IndexChecker(const Document& document) : document_(document), model_(document.model), report_(document.report) {}

  void run() const {
    for_each(model_.bufferViews, "bufferViews", [&](const auto& view, const std::string& where) {
      require(view.buffer, document_.buffers.size(), "buffers", where);
    });
    for_each(model_.accessors, "accessors", [&](const auto& a, const std::string& where) { check(a, where); });
    for_each(model_.meshes, "meshes", [&](const auto& mesh, const std::string& where) {
      for (const tinygltf::Primitive& primitive : mesh.primitives) check(primitive, where);
    });
    for_each(model_.skins, "skins", [&](const auto& skin, const std::string& where) { check(skin, where); });
    for_each(model_.textures, "textures", [&](const auto& texture, const std::string& where) {
      allow(texture.sampler, model_.samplers.size(), "samplers", where);
      allow(texture.source, document_.images.size(), "images", where);
    });
    for_each(model_.nodes, "nodes", [&](const auto& node, const std::string& where) { check(node, where); });
    for_each(model_.scenes, "scenes", [&](const auto& scene, const std::string& where) {
      for (const int node : scene.nodes) require(node, model_.nodes.size(), "nodes", where);
    });
    allow(model_.defaultScene, model_.scenes.size(), "scenes", "scene");
    for_each(model_.animations, "animations", [&](const auto& a, const std::string& where) { check(a, where); });
  }

 private:
  template <class T, class F>
  static void for_each(const std::vector<T>& elements, const char* array, const F& check) {
    for (std::size_t i = 0; i < elements.size(); ++i) check(elements[i], element(array, i));
  }

  void require(int index, std::size_t count, const char* array, const std::string& where) const {
    if (index < 0 || static_cast<std::size_t>(index) >= count)
      report_.fail(where, fmt::format("refers to {}[{}], but there are {}", array, index, count));
  }
  /// -1: the file does not have it.
  void allow(int index, std::size_t count, const char* array, const std::string& where) const {
    if (index != -1) require(index, count, array, where);
  }

  void check(const tinygltf::Accessor& a, const std::string& where) const {
    allow(a.bufferView, model_.bufferViews.size(), "bufferViews", where);
    if (!a.sparse.isSparse) return;
    require(a.sparse.indices.bufferView, model_.bufferViews.size(), "bufferViews", where + ".sparse.indices");
    require(a.sparse.values.bufferView, model_.bufferViews.size(), "bufferViews", where + ".sparse.values");
  }

  void check(const tinygltf::Primitive& primitive, const std::string& where) const {
    const auto check_attributes = [&](const std::map<std::string, int>& attributes) {
      for (const auto& [name, accessor] : attributes) require(accessor, model_.accessors.size(), "accessors", where);
    };
    check_attributes(primitive.attributes);
    for (const std::map<std::string, int>& target : primitive.targets) check_attributes(target);
    allow(primitive.indices, model_.accessors.size(), "accessors", where);
    allow(primitive.material, model_.materials.size(), "materials", where);
  }

  void check(const tinygltf::Skin& skin, const std::string& where) const {
    for (const int joint : skin.joints) require(joint, model_.nodes.size(), "nodes", where);
    allow(skin.inverseBindMatrices, model_.accessors.size(), "accessors", where);
  }

  void check(const tinygltf::Node& node, const std::string& where) const {
    for (const int child : node.children) require(child, model_.nodes.size(), "nodes", where);
    allow(node.mesh, model_.meshes.size(), "meshes", where);
    allow(node.skin, model_.skins.size(), "skins", where);
    allow(node.camera, model_.cameras.size(), "cameras", where);
    if (const auto lamp = node.extensions.find("KHR_lights_punctual"); lamp != node.extensions.end())
      require(lamp->second.Get("light").GetNumberAsInt(), model_.lights.size(), "lights", where);
  }

  void check(const tinygltf::Animation& animation, const std::string& where) const {
    for (const tinygltf::AnimationSampler& sampler : animation.samplers) {
      require(sampler.input, model_.accessors.size(), "accessors", where);
      require(sampler.output, model_.accessors.size(), "accessors", where);
    }
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const std::string channel = fmt::format("{}.channels[{}]", where, i);
      require(animation.channels[i].sampler, animation.samplers.size(), "samplers", channel);
      allow(animation.channels[i].target_node, model_.nodes.size(), "nodes", channel);
    }
  }

  const Document& document_;
  const tinygltf::Model& model_;
  const Report& report_;
};

}  // namespace

void check_indices(const Document& document) { IndexChecker(document).run(); }

}  // namespace lippmann::gltf
