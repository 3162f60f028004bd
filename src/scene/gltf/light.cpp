// Based on: Khronos Group, "KHR_lights_punctual", 2018: point and spot lights have an intensity in candela and fall off with
// the squared distance, directional ones an illuminance in lux; all shine along their node's -z.
#include "scene/gltf/light.hpp"

namespace lippmann::gltf {
namespace {

/// Blender's exporter turns its watts into candela and lux by the luminous efficacy that the specification suggests (unless
/// told otherwise), and emission not: taken as they are, its lamps would outshine everything.
constexpr float kLumensPerWatt = 683.0f;

bool is_of_blender(const tinygltf::Model& model) { return model.asset.generator.find("Blender I/O") != std::string::npos; }

Light read_light(const tinygltf::Light& from, const std::string& where, const Report& report) {
  Light light;
  light.name = from.name;
  if (!from.color.empty()) light.color = Vec3f(from.color[0], from.color[1], from.color[2]);
  light.color *= static_cast<float>(from.intensity);
  light.range = from.range > 0.0 ? static_cast<float>(from.range) : kInfinity;
  if (from.type == "directional") {
    light.kind = LightKind::kDirectional;
    return light;
  }
  light.inverse_square = true;
  if (from.type == "point") return light;
  light.kind = LightKind::kSpot;
  light.inner_cone = static_cast<float>(from.spot.innerConeAngle);
  light.outer_cone = static_cast<float>(from.spot.outerConeAngle);
  if (light.inner_cone > light.outer_cone) report.fail(where + ".spot", "the inner cone is wider than the outer one");
  return light;
}

}  // namespace

void read_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(nodes.file_node[i])];
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) continue;
    const std::size_t index = static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
    scene.lights.push_back(read_light(document.model.lights[index], element("lights", index), document.report));
    scene.lights.back().node = static_cast<int>(i);
    if (is_of_blender(document.model)) scene.lights.back().color /= kLumensPerWatt;
  }
}

}  // namespace lippmann::gltf
