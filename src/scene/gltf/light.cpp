// Based on: Khronos Group, "KHR_lights_punctual", 2018. Point and spot lights have an intensity in candela and an
// inverse-square falloff. Directional lights have an illuminance in lux. Directional and spot lights shine along their node's
// -z.
#include "scene/gltf/light.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace lippmann::gltf {
namespace {

constexpr const char* kPunctual = "KHR_lights_punctual";

/// Blender's exporter multiplies the power of lamps by this factor, in lumens per watt, but not the emission of surfaces.
/// Without the reverse conversion, lamps would be 683 times too bright relative to surfaces.
constexpr float kLumensPerWatt = 683.0f;

using Version = std::array<int, 3>;

/// The first exporter version that converts units (released with Blender 3.4). Earlier versions wrote watts for point and spot
/// lamps, emitted into 4 pi steradians, and watts per square metre for suns.
constexpr Version kFirstInLumens{3, 4, 39};

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

bool is_unnumbered_exporter(std::string_view generator) {
  return generator.find("Khronos Blender glTF 2.0 I/O") != generator.npos;
}

bool is_blender_exporter(std::string_view generator) {
  return is_unnumbered_exporter(generator) || generator.find("Blender I/O") != generator.npos;
}

/// Returns the factor that converts a light's intensity to watts per steradian, or to watts per square metre for suns, which
/// are the units of emissive surfaces.
float scale_of(std::string_view generator, LightKind kind) {
  if (!is_blender_exporter(generator)) return 1.0f;
  if (!is_unnumbered_exporter(generator) && version_in(generator) >= kFirstInLumens) return 1.0f / kLumensPerWatt;
  return kind == LightKind::kDirectional ? 1.0f : 1.0f / (4.0f * kPi);
}

/// Returns a custom property of a light. Blender's custom properties and our add-on store the sizes of lights there
/// (docs/reference/gltf.md).
float extra(Value from, const char* name) { return static_cast<float>(from["extras"][name].number(0.0)); }

/// Sets the inner cone so that the soft edge covers the fraction `blend` of the cosines from cos(outer cone) to 1.
void blend_edge(float blend, Light& light) {
  const float cos_outer = std::cos(light.outer_cone);
  light.inner_cone = std::min(std::acos(cos_outer + (1.0f - cos_outer) * blend), light.outer_cone);
  light.smooth_edge = true;
}

/// Blender's exporter writes inner = outer (1 - blend), from which `blend` is computed.
void read_edge(Value from, std::string_view generator, Light& light) {
  if (from["extras"]["blend"])
    blend_edge(extra(from, "blend"), light);
  else if (is_blender_exporter(generator) && light.outer_cone > 0.0f)
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
