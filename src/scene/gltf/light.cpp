// Based on: Khronos Group, "KHR_lights_punctual", 2018: point and spot lights have an intensity in candela and fall off with
// the squared distance, directional ones an illuminance in lux; all shine along their node's -z.
#include "scene/gltf/light.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace lippmann::gltf {
namespace {

/// Blender's exporter turns its watts into candela and lux by the luminous efficacy that the specification suggests (unless
/// told otherwise), and emission not: taken as they are, its lamps would outshine everything.
constexpr float kLumensPerWatt = 683.0f;

using Version = std::array<int, 3>;

/// The first exporter that converts units (October 2022, released with Blender 3.4). Those before wrote Blender's own numbers:
/// watts of point and spot lamps, which shine into 4 pi steradians, and watts per square metre of suns.
constexpr Version kFirstInLumens{3, 4, 39};

/// "3.4.50" in "... v3.4.50"; numbers that are missing are 0.
Version version_in(std::string_view generator) {
  Version version{};
  const std::size_t v = generator.rfind(" v");
  if (v == generator.npos) return version;
  const char *at = generator.data() + v + 2, *const end = generator.data() + generator.size();
  for (int& number : version) {
    at = std::from_chars(at, end, number).ptr;
    if (at != end && *at == '.') ++at;
  }
  return version;
}

/// The exporter's name before version 1.0.0, which had no number.
bool is_of_unnumbered_exporter(std::string_view generator) {
  return generator.find("Khronos Blender glTF 2.0 I/O") != generator.npos;
}

bool is_of_blender(std::string_view generator) {
  return is_of_unnumbered_exporter(generator) || generator.find("Blender I/O") != generator.npos;
}

/// What a light's intensity is multiplied by, so that lamps are as bright beside emission as where the file was made.
float scale_of(std::string_view generator, LightKind kind) {
  if (!is_of_blender(generator)) return 1.0f;
  if (!is_of_unnumbered_exporter(generator) && version_in(generator) >= kFirstInLumens) return 1.0f / kLumensPerWatt;
  return kind == LightKind::kDirectional ? 1.0f : 1.0f / (4.0f * kPi);
}

/// Sizes have no place in the extension: custom properties of the light in Blender, and what its add-on writes (docs/gltf.md).
float extra(const tinygltf::Light& from, const char* name) {
  return from.extras.Has(name) ? static_cast<float>(from.extras.Get(name).GetNumberAsDouble()) : 0.0f;
}

/// Blender's soft edge in place of the inner cone: a part of the cosines from the outer cone's to 1.
void blend_edge(float blend, Light& light) {
  const float cos_outer = std::cos(light.outer_cone);
  light.inner_cone = std::min(std::acos(cos_outer + (1.0f - cos_outer) * blend), light.outer_cone);
  light.smooth_edge = true;
}

/// The edge between the cones: the extension's own, or Blender's, of which its exporter writes inner = outer (1 - blend).
void read_edge(const tinygltf::Light& from, std::string_view generator, Light& light) {
  if (from.extras.Has("blend"))
    blend_edge(extra(from, "blend"), light);
  else if (is_of_blender(generator) && light.outer_cone > 0.0f)
    blend_edge(1.0f - light.inner_cone / light.outer_cone, light);
}

Light read_light(const tinygltf::Light& from, std::string_view generator, const std::string& where, const Report& report) {
  Light light;
  light.name = from.name;
  if (!from.color.empty()) light.color = Vec3f(from.color[0], from.color[1], from.color[2]);
  light.color *= static_cast<float>(from.intensity);
  light.range = from.range > 0.0 ? static_cast<float>(from.range) : kInfinity;
  if (from.type == "directional") {
    light.kind = LightKind::kDirectional;
    light.angular_diameter = std::min(extra(from, "angle"), kPi);
    return light;
  }
  light.inverse_square = true;
  light.radius = extra(from, "radius");
  if (from.type == "point") return light;
  light.kind = LightKind::kSpot;
  light.inner_cone = static_cast<float>(from.spot.innerConeAngle);
  light.outer_cone = static_cast<float>(from.spot.outerConeAngle);
  if (light.inner_cone > light.outer_cone) report.fail(where + ".spot", "the inner cone is wider than the outer one");
  read_edge(from, generator, light);
  return light;
}

}  // namespace

void read_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(nodes.file_node[i])];
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end() || nodes.hidden[i]) continue;
    const std::size_t index = static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
    const std::string& generator = document.model.asset.generator;
    Light light = read_light(document.model.lights[index], generator, element("lights", index), document.report);
    light.node = static_cast<int>(i);
    light.color *= scale_of(generator, light.kind);
    scene.lights.push_back(std::move(light));
  }
}

}  // namespace lippmann::gltf
