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

constexpr const char* kPunctual = "KHR_lights_punctual";

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

/// Sizes have no place in the extension: custom properties of the light in Blender, and what its add-on writes
/// (docs/reference/gltf.md).
float extra(Value from, const char* name) { return static_cast<float>(from["extras"][name].number(0.0)); }

/// Blender's soft edge in place of the inner cone: a part of the cosines from the outer cone's to 1.
void blend_edge(float blend, Light& light) {
  const float cos_outer = std::cos(light.outer_cone);
  light.inner_cone = std::min(std::acos(cos_outer + (1.0f - cos_outer) * blend), light.outer_cone);
  light.smooth_edge = true;
}

/// The edge between the cones: the extension's own, or Blender's, of which its exporter writes inner = outer (1 - blend).
void read_edge(Value from, std::string_view generator, Light& light) {
  if (from["extras"]["blend"])
    blend_edge(extra(from, "blend"), light);
  else if (is_of_blender(generator) && light.outer_cone > 0.0f)
    blend_edge(1.0f - light.inner_cone / light.outer_cone, light);
}

Light read_light(Value from, std::string_view generator, const std::string& where, const Report& report) {
  Light light;
  light.name = from["name"].text();
  light.color = static_cast<float>(from["intensity"].number(1.0)) * from["color"].vector(Vec3f(1.0f));
  light.range = static_cast<float>(from["range"].number(kInfinity));
  const std::string& type = from["type"].text();
  if (type == "directional") {
    light.kind = LightKind::kDirectional;
    light.angular_diameter = std::min(extra(from, "angle"), kPi);
    return light;
  }
  light.inverse_square = true;
  light.radius = extra(from, "radius");
  if (type == "point") return light;
  light.kind = LightKind::kSpot;
  const Value spot = from["spot"];
  if (!spot) report.fail(where + ".spot", "is missing");
  light.inner_cone = static_cast<float>(spot["innerConeAngle"].number(0.0));
  light.outer_cone = static_cast<float>(spot["outerConeAngle"].number(light.outer_cone));
  if (light.inner_cone > light.outer_cone) report.fail(where + ".spot", "the inner cone is wider than the outer one");
  read_edge(from, generator, light);
  return light;
}

}  // namespace

void read_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const Value extension = document.at("nodes", nodes.file_node[i]).extension(kPunctual);
    if (!extension || nodes.hidden[i]) continue;
    const std::size_t index = extension["light"].count();
    const std::string& generator = document.root["asset"]["generator"].text();
    const Value from = document.root.extension(kPunctual)["lights"].at(index);
    Light light = read_light(from, generator, element("lights", index), document.report);
    light.node = static_cast<int>(i);
    light.color *= scale_of(generator, light.kind);
    scene.lights.push_back(std::move(light));
  }
}

}  // namespace lippmann::gltf
