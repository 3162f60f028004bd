#include "shading/materials.hpp"

#include "shading/surface_bsdf.hpp"
#include "transport/light_range.hpp"

namespace lippmann {
namespace {

// Returns the N.H below which the highlight is weaker than 2^-14, a fifth of the first 8-bit sRGB code.
float cutoff_for(float highlight, float size) {
  if (highlight <= 0.0f) return 2.0f;
  return std::pow(std::min(1.0f, 0x1p-14f / highlight), 1.0f / std::max(size, 1e-3f));
}

WhittedMaterial from(const PhongSurface& s, MaterialTable& table) {
  WhittedMaterial m;
  m.color = s.color;
  m.ambient = Vec3f(s.ambient);
  m.diffuse = s.diffuse;
  if (s.highlight_kind != Highlight::kNone) m.highlight = s.highlight;
  m.highlight_size = s.highlight_size;
  m.highlight_cutoff = cutoff_for(m.highlight, m.highlight_size);
  m.highlight_tint = s.highlight_kind == Highlight::kMetal ? 1.0f : 0.0f;
  m.mirror = s.mirror;
  m.opacity = s.opacity;
  m.ior = s.ior;
  m.emission = in_light_range(s.emission);
  m.color_map.texture = s.texture;
  if (s.projection) {
    m.projection = static_cast<int>(table.projections.size());
    table.projections.push_back(*s.projection);
  }
  return m;
}

// Surfaces below this roughness show a mirror image, which gets stronger towards roughness 0.
constexpr float kMirrorRoughness = 0.4f;

// KHR_materials_ior: materials with total reflection have this index of refraction.
constexpr float kMirrorLikeIor = 1000.0f;

WhittedMaterial from(const MetallicRoughness& s, Vec3f surroundings) {
  WhittedMaterial m;
  m.color = Vec3f(s.base_color);
  m.color_map = s.base_color_map;
  m.has_alpha = s.blend || s.alpha_cutoff > 0.0f;
  m.alpha_cutoff = s.blend ? 0.0f : s.alpha_cutoff;
  m.base_alpha = s.base_color.a;
  m.opacity = s.blend ? s.base_color.a : 1.0f;
  m.emission = in_light_range(s.emissive);
  m.emission_map = s.emissive_map;
  if (s.unlit) {
    m.ambient = Vec3f(1.0f);
    m.diffuse = 0.0f;
    return m;
  }
  float dielectric_f0 = ((s.ior - 1.0f) / (s.ior + 1.0f)) * ((s.ior - 1.0f) / (s.ior + 1.0f));
  if (s.ior >= kMirrorLikeIor)  // the specular colour alone determines the reflectance
    dielectric_f0 *= s.specular * (s.specular_color.x + s.specular_color.y + s.specular_color.z) / 3.0f;
  const float smooth = std::max(0.0f, 1.0f - s.roughness / kMirrorRoughness);
  m.mirror = smooth * glm::mix(dielectric_f0, 1.0f, s.metallic);
  m.mirror_tint = s.metallic;
  m.diffuse = (1.0f - s.metallic) * (1.0f - s.transmission) / kPi;
  // Ambient light approximates the light of the background, which is not traced. Diffuse surfaces receive its mean radiance. On
  // metal, the mean radiance replaces the part of the mirror image that `mirror` leaves out.
  m.ambient = surroundings * ((1.0f - s.metallic) * (1.0f - s.transmission) + s.metallic * (1.0f - smooth));
  const float alpha = std::max(s.roughness * s.roughness, 0.01f);
  m.highlight_size = std::max(1.0f, 2.0f / (alpha * alpha) - 2.0f);
  // Peak of the normalised Blinn-Phong lobe at normal incidence, (n + 2) / 8 pi: Real-Time Rendering, 4th ed., section 9.8.
  m.highlight = glm::mix(dielectric_f0, 1.0f, s.metallic) * (m.highlight_size + 2.0f) / (8.0f * kPi);
  m.highlight_tint = s.metallic;
  m.highlight_cutoff = cutoff_for(m.highlight, m.highlight_size);
  if (s.transmission > 0.0f) {
    m.opacity = 1.0f - s.transmission;
    m.ior = is_thin_wall(s) ? 1.0f : s.ior;
    m.wall_ior = is_thin_wall(s) ? s.ior : 0.0f;
  }
  return m;
}

bool is_matt(const MetallicRoughness& s) {
  return !s.unlit && !s.extensions && s.metallic == 0.0f && s.specular == 0.0f && s.transmission == 0.0f &&
         s.clearcoat == 0.0f && s.normal_map.texture < 0;
}

void prepare_for_paths(const Material& material, WhittedMaterial& m) {
  const auto* surface = std::get_if<MetallicRoughness>(&material.surface);
  if (!surface) {
    m.blocks_light = m.ior != 1.0f;
    m.is_whole = true;
    return;
  }
  m.opacity = surface->blend ? surface->base_color.a : 1.0f;
  if (!is_matt(*surface) || m.has_alpha) return;
  m.is_whole = true;
  m.diffuse = 1.0f;
  m.ambient = Vec3f(0.0f);
  m.highlight = m.mirror = 0.0f;
}

}  // namespace

MaterialTable make_material_table(const Scene& scene, Vec3f surroundings, MaterialUse use) {
  MaterialTable table;
  for (const Material& material : scene.materials) {
    if (const auto* phong = std::get_if<PhongSurface>(&material.surface))
      table.materials.push_back(from(*phong, table));
    else
      table.materials.push_back(from(std::get<MetallicRoughness>(material.surface), surroundings));
    if (use == MaterialUse::kPaths) prepare_for_paths(material, table.materials.back());
  }
  return table;
}

float shadow_transmittance(const WhittedMaterial& material) {
  return material.blocks_light ? 0.0f : std::clamp(1.0f - material.opacity, 0.0f, 1.0f);
}

namespace {

/// Returns the rotation from world to node directions, without the node's scale, or the identity if the scale is 0.
Mat3f rotation_to(const Affine3f& world_from_node) {
  Mat3f axes(1.0f);
  for (int c = 0; c < 3; ++c) {
    const float length = glm::length(world_from_node.linear[c]);
    if (!(length > 0.0f)) return Mat3f(1.0f);
    axes[c] = world_from_node.linear[c] / length;
  }
  return glm::transpose(axes);
}

}  // namespace

std::vector<WhittedLight> make_lights(const Scene& scene, const ResolvedScene& resolved) {
  std::vector<WhittedLight> lights;
  for (const Light& light : scene.lights) {
    const Affine3f world_from_light = resolved.of(light.node);
    const bool directional = light.kind == LightKind::kDirectional, spot = light.kind == LightKind::kSpot;
    const bool linear_cones = scene.encoding == Encoding::kTachyonTruncate;
    const float cos_inner = std::cos(light.inner_cone), cos_outer = std::cos(light.outer_cone);
    WhittedLight w;
    w.position = world_from_light.translation;
    w.toward = -glm::normalize(transform_vector(world_from_light, {0, 0, -1}));
    w.color = in_light_range(light.color);
    w.at_place = directional ? 0.0f : 1.0f;
    w.falls_off = light.inverse_square && !directional ? 1.0f : 0.0f;
    w.range = directional ? kInfinity : light.range;
    w.beyond = directional ? kInfinity : 0.0f;
    w.has_cone = spot && !linear_cones ? 1.0f : 0.0f;
    w.cos_outer = cos_outer;
    w.inverse_ramp = 1.0f / std::max(cos_inner - cos_outer, 1e-6f);
    w.linear_cone = spot && linear_cones;
    w.inner_cone = light.inner_cone;
    w.outer_cone = light.outer_cone;
    w.attenuates = !directional && light.attenuation != Vec3f(1.0f, 0.0f, 0.0f);
    w.attenuation = light.attenuation;
    w.visible_radius = light.visible_radius;
    w.has_smooth_edge = light.smooth_edge ? 1.0f : 0.0f;
    w.radius = directional ? 0.0f : light.radius;
    w.half_angle = directional ? 0.5f * light.angular_diameter : 0.0f;
    if (light.web >= 0) {
      w.web = &scene.webs[static_cast<std::size_t>(light.web)];
      w.light_from_world = rotation_to(world_from_light);
    }
    lights.push_back(w);
  }
  return lights;
}

}  // namespace lippmann
