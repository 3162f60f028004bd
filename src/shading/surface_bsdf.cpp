#include "shading/surface_bsdf.hpp"

#include "shading/lifted_normal.hpp"
#include "shading/look_up.hpp"

namespace lippmann {
namespace {

/// Computes tangent and bitangent from the mesh's tangents if there are any, otherwise from the map's texture coordinates.
/// Returns false if the result is degenerate.
bool tangent_frame(const Maps& maps, const TextureMap& map, Vec3f normal, Vec3f& tangent, Vec3f& bitangent) {
  const Mesh& mesh = *maps.record->mesh;
  const auto& corners = mesh.triangles[maps.triangle];
  const Mat3f linear = maps.record->placed ? maps.record->world_from_mesh.linear : Mat3f(1.0f);
  if (!mesh.tangents.empty() && map.uv_set == 0) {
    const Vec4f t = interpolate(mesh.tangents, corners, maps.at);
    tangent = linear * Vec3f(t);
    tangent -= normal * glm::dot(normal, tangent);
    bitangent = (t.w < 0.0f ? -1.0f : 1.0f) * (glm::determinant(linear) < 0.0f ? -1.0f : 1.0f) * glm::cross(normal, tangent);
  } else {
    const std::vector<Vec2f>& uvs = uvs_of(mesh, map.uv_set);
    if (uvs.empty()) return false;
    const Vec3f edge_b = linear * (mesh.positions[corners[1]] - mesh.positions[corners[0]]);
    const Vec3f edge_c = linear * (mesh.positions[corners[2]] - mesh.positions[corners[0]]);
    const Vec2f b = uvs[corners[1]] - uvs[corners[0]], c = uvs[corners[2]] - uvs[corners[0]];
    const float turned = b.x * c.y - c.x * b.y < 0.0f ? -1.0f : 1.0f;
    tangent = turned * (edge_b * c.y - edge_c * b.y);
    bitangent = -turned * (edge_c * b.x - edge_b * c.x);  // v falls in this direction, which is upwards in the image
    tangent -= normal * glm::dot(normal, tangent);
    bitangent -= normal * glm::dot(normal, bitangent);
  }
  const float t = glm::length(tangent), b = glm::length(bitangent);
  if (!(t > 0.0f && b > 0.0f)) return false;
  tangent /= t, bitangent /= b;
  return true;
}

/// Applies a normal map (glTF 2.0 specification, section 3.9.3). outer: 1 if the viewer is on the outer side, otherwise -1.
Vec3f mapped_normal(const Maps& maps, const TextureMap& map, float scale, Vec3f normal, float outer) {
  Vec3f tangent, bitangent;
  if (!tangent_frame(maps, map, outer * normal, tangent, bitangent)) return normal;
  const Vec3f n = 2.0f * Vec3f(maps(map)) - Vec3f(1.0f);
  const Vec3f bent = scale * (n.x * tangent + n.y * bitangent) + std::max(n.z, 1e-3f) * outer * normal;
  return outer * glm::normalize(bent);
}

MetalRoughSurface surface_at(const MetallicRoughness& m, Vec3f base_color, const Maps& maps) {
  const Vec4f metallic_roughness = maps(m.metallic_roughness_map);
  MetalRoughSurface s;
  s.base_color = glm::clamp(base_color, Vec3f(0.0f), Vec3f(1.0f));
  s.metallic = m.metallic * metallic_roughness.b;
  s.roughness = m.roughness * metallic_roughness.g;
  s.ior = m.ior;
  s.specular = m.specular * maps(m.specular_map).a;
  s.specular_color = m.specular_color * Vec3f(maps(m.specular_color_map));
  s.transmission = m.transmission > 0.0f ? m.transmission * maps(m.transmission_map).r : 0.0f;
  if (m.clearcoat > 0.0f) {
    s.clearcoat = m.clearcoat * maps(m.clearcoat_map).r;
    s.clearcoat_roughness = m.clearcoat_roughness * maps(m.clearcoat_roughness_map).g;
  }
  return s;
}

/// Returns the tangent, turned by the anisotropy's map and rotation, or the null vector if the mesh has no tangents. Multiplies
/// `strength` by the map's blue channel.
Vec3f anisotropy_direction(const Anisotropy& anisotropy, const Maps& maps, Vec3f normal, float outer, float& strength) {
  Vec3f tangent, bitangent;
  if (!maps.record || !tangent_frame(maps, anisotropy.map, outer * normal, tangent, bitangent)) return Vec3f(0.0f);
  Vec2f along(1.0f, 0.0f);
  if (anisotropy.map.texture >= 0) {
    const Vec4f texel = maps(anisotropy.map);
    along = {2.0f * texel.r - 1.0f, 2.0f * texel.g - 1.0f};
    strength *= texel.b;
  }
  const float c = std::cos(anisotropy.rotation), s = std::sin(anisotropy.rotation);
  return (c * along.x - s * along.y) * tangent + (s * along.x + c * along.y) * bitangent;
}

void set_film(const Iridescence& from, const Maps& maps, LayeredSurface& s) {
  s.film_share = from.share * maps(from.map).r;
  s.film.ior = from.ior;
  s.film.thickness_nm = glm::mix(from.least_thickness_nm, from.most_thickness_nm, maps(from.thickness_map).g);
  if (!(s.film.thickness_nm > 0.0f)) s.film_share = 0.0f;
}

bool is_layered(const SurfaceExtensions& e) {
  return e.sheen.color != Vec3f(0.0f) || e.anisotropy.strength > 0.0f || e.iridescence.share > 0.0f ||
         e.diffuse_transmission.share > 0.0f || (e.volume && !e.volume->is_solid);
}

LayeredSurface layered_surface(const MetalRoughSurface& base, const SurfaceExtensions& e, const Maps& maps) {
  LayeredSurface s;
  s.base = base;
  s.sheen_color = glm::clamp(e.sheen.color * Vec3f(maps(e.sheen.color_map)), Vec3f(0.0f), Vec3f(1.0f));
  s.sheen_roughness = e.sheen.roughness * maps(e.sheen.roughness_map).a;
  if (e.iridescence.share > 0.0f) set_film(e.iridescence, maps, s);
  s.diffuse_transmission = e.diffuse_transmission.share * maps(e.diffuse_transmission.map).a;
  s.diffuse_transmission_color = e.diffuse_transmission.color * Vec3f(maps(e.diffuse_transmission.color_map));
  s.is_thin = e.volume && !e.volume->is_solid;
  s.shadow_rays_pass = s.is_thin && maps.record;
  return s;
}

/// Returns the index of refraction of a colour channel, after Khronos Group, KHR_materials_dispersion. Green has the material's
/// index.
float ior_of_channel(float ior, float dispersion, int channel) {
  const float half_spread = (ior - 1.0f) * 0.025f * dispersion;
  return std::max(1.0f, ior + static_cast<float>(channel - 1) * half_spread);
}

void disperse(const SurfaceExtensions& e, int channel, MetalRoughSurface& s) {
  const bool bends = !e.volume || e.volume->is_solid;
  if (bends && e.dispersion > 0.0f && s.transmission > 0.0f) s.ior = ior_of_channel(s.ior, e.dispersion, channel);
}

struct Facing {
  MetalRoughBsdf::Normals normals;
  Vec3f view;
  bool entering;
};

[[gnu::noinline]] Bsdf layered_bsdf(const MetalRoughSurface& base, const SurfaceExtensions& e, const Maps& maps,
                                    const GgxAlbedo& albedo, const Facing& facing) {
  LayeredSurface s = layered_surface(base, e, maps);
  Vec3f along(0.0f);
  float strength = e.anisotropy.strength;
  if (strength > 0.0f)
    along = anisotropy_direction(e.anisotropy, maps, facing.normals.gloss, facing.entering ? 1.0f : -1.0f, strength);
  if (along != Vec3f(0.0f)) s.anisotropy = strength;
  return Bsdf(std::in_place_type<LayeredBsdf>, s, albedo, facing.normals, along, facing.view, facing.entering);
}

}  // namespace

Vec4f Maps::operator()(const TextureMap& map) const {
  return record && map.texture >= 0 ? look_up(map, textures, *record->mesh, triangle, at) : Vec4f(1.0f);
}

bool is_thin_wall(const MetallicRoughness& m) {
  return m.extensions && m.extensions->volume && !m.extensions->volume->is_solid;
}

bool is_base_alone(const MetallicRoughness& m) { return m.clearcoat == 0.0f && !(m.extensions && is_layered(*m.extensions)); }

MetalRoughPoint metal_rough_point(const MetallicRoughness& m, Vec3f color, const Maps& maps, const SeenPoint& p, int channel) {
  const float outer = p.entering ? 1.0f : -1.0f;
  const auto mapped = [&](const TextureMap& map, float scale) {
    return map.texture >= 0 && maps.record ? mapped_normal(maps, map, scale, p.normal, outer) : p.normal;
  };
  MetalRoughPoint at;
  at.surface = surface_at(m, color, maps);
  if (m.extensions) disperse(*m.extensions, channel, at.surface);
  const auto lifted = [&](Vec3f n) { return lifted_normal(n, p.facet, p.view); };
  MetalRoughBsdf::Normals& normals = at.normals;
  normals.diffuse = normals.gloss = mapped(m.normal_map, m.normal_scale);
  if (at.surface.metallic > 0.0f || at.surface.specular > 0.0f || at.surface.transmission > 0.0f)
    normals.gloss = lifted(normals.gloss);
  // Metals and glass use the lifted normal for all terms. The diffuse term of other surfaces keeps its normal, because lifting
  // would remove most of its light.
  if (at.surface.metallic > 0.0f || at.surface.transmission > 0.0f) normals.diffuse = normals.gloss;
  if (m.clearcoat > 0.0f) normals.coat = lifted(mapped(m.clearcoat_normal_map, m.clearcoat_normal_scale));
  return at;
}

Bsdf metal_rough_bsdf(const MetallicRoughness& m, Vec3f color, const Maps& maps, const GgxAlbedo& albedo, const SeenPoint& p,
                      int channel) {
  const auto [surface, normals] = metal_rough_point(m, color, maps, p, channel);
  if (m.extensions && is_layered(*m.extensions))
    return layered_bsdf(surface, *m.extensions, maps, albedo, {normals, p.view, p.entering});
  return Bsdf(std::in_place_type<MetalRoughBsdf>, surface, albedo, normals, p.view, p.entering);
}

}  // namespace lippmann
