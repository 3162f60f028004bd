// Based on: Khronos Group, "EXT_mesh_gpu_instancing", 2021. The transform of a copy is the node's transform times the copy's
// translation, rotation and scale.
#include "scene/gltf/instancing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.hpp"

namespace lippmann::gltf {
namespace {

template <class T>
std::vector<T> read_attribute(Document& document, Value attributes, const char* name) {
  const int accessor = attributes[name].index();
  return accessor < 0 ? std::vector<T>() : unpack<T>(document, accessor);
}

Quatf unit_rotation(Vec4f v, std::size_t index, const std::string& where, const Report& report) {
  const Quatf q(v.w, v.x, v.y, v.z);
  const float length = glm::length(q);
  if (!(length > 1e-6f) || !std::isfinite(length))
    report.fail(where, fmt::format("the rotation of copy {} is not a unit quaternion", index));
  return q / length;
}

}  // namespace

std::vector<int> read_places(Document& document, int file_node, int scene_node, Scene& scene) {
  const std::string where = element("nodes", static_cast<std::size_t>(file_node)) + ".extensions." + kInstancing;
  const Value attributes = document.at("nodes", file_node).extension(kInstancing)["attributes"];
  const std::vector<Vec3f> translations = read_attribute<Vec3f>(document, attributes, "TRANSLATION");
  const std::vector<Vec4f> rotations = read_attribute<Vec4f>(document, attributes, "ROTATION");
  const std::vector<Vec3f> scales = read_attribute<Vec3f>(document, attributes, "SCALE");
  const std::size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  for (const std::size_t size : {translations.size(), rotations.size(), scales.size()})
    if (size != 0 && size != count)
      document.report.fail(where, fmt::format("has {} values of one attribute and {} of another", size, count));
  if (count == 0)
    document.report.fail(where, "has none of the attributes that place its copies", "TRANSLATION, ROTATION, SCALE");

  document.unpacked.spend(count, sizeof(Node), where, document.report);
  std::vector<int> places;
  for (std::size_t i = 0; i < count; ++i) {
    Node copy;
    copy.parent = scene_node;
    if (!translations.empty()) copy.local.translation = translations[i];
    if (!rotations.empty()) copy.local.rotation = unit_rotation(rotations[i], i, where, document.report);
    if (!scales.empty()) copy.local.scale = scales[i];
    copy.morph_weights = scene.nodes[static_cast<std::size_t>(scene_node)].morph_weights;
    document.unpacked.spend(copy.morph_weights.size(), sizeof(float), where, document.report);
    places.push_back(static_cast<int>(scene.nodes.size()));
    scene.nodes.push_back(std::move(copy));
  }
  return places;
}

}  // namespace lippmann::gltf
