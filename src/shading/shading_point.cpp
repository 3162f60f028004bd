#include "shading/shading_point.hpp"

namespace lippmann {
namespace {

const Material& material_of(const ShadedScene& scene, const SurfacePacket& surface, int i) {
  return scene.scene->materials[scene.material_of_instance[surface.instance[i]]];
}

const GeometryRecord* mesh_record(const ShadedScene& scene, const SurfacePacket& surface, int i) {
  if (surface.record[i] >= kPlaneId) return nullptr;
  const GeometryRecord& record = scene.records[surface.record[i]];
  return record.kind == GeometryKind::kMesh ? &record : nullptr;
}

Maps maps_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i) {
  return {scene.textures, mesh_record(scene, surface, i), packet.hit.primID[i], {packet.hit.u[i], packet.hit.v[i]}};
}

SeenPoint seen_point(const RayHitPacket& packet, const SurfacePacket& surface, int i) {
  return {surface.normal.get(i), view_of(packet, i), surface.entering.lane[i] != 0, surface.facet.get(i)};
}

/// Converts a purely diffuse Phong surface to metallic roughness. Returns nothing for other surfaces.
std::optional<MetalRoughPoint> lambert_at(const SurfacePacket& surface, int i) {
  if (surface.highlight[i] != 0.0f || surface.mirror[i] != 0.0f || surface.opacity[i] != 1.0f) return std::nullopt;
  MetalRoughPoint at;
  at.surface.base_color = surface.diffuse[i] * surface.color.get(i);
  at.surface.metallic = at.surface.specular = 0.0f;
  at.normals.diffuse = at.normals.gloss = surface.normal.get(i);
  return at;
}

bool lets_through(const MetallicRoughness& m) {
  return m.transmission > 0.0f || (m.extensions && m.extensions->diffuse_transmission.share > 0.0f);
}

std::uint16_t medium_behind(const SurfaceExtensions& extensions, const ShadedScene& scene, const SurfacePacket& surface,
                            int i) {
  if (!extensions.volume || !extensions.volume->is_solid) return kSameMedium;
  if (!surface.entering.lane[i]) return kNoMedium;
  return scene.path->media.of_material(scene.material_of_instance[surface.instance[i]]);
}

}  // namespace

ShadingPoint shading_point(const ShadedScene& scene, const SurfacePacket& surface, int i) {
  ShadingPoint p;
  p.position = surface.position.get(i);
  p.facet = surface.facet.get(i);
  p.normal = surface.normal.get(i);
  if (surface.any_smooth) p.smooth = &surface, p.lane = i;
  p.base_color = surface.color.get(i);
  p.emission = surface.emission.get(i);
  p.t_near = surface.t_near[i];
  if (const auto* m = std::get_if<MetallicRoughness>(&material_of(scene, surface, i).surface)) {
    p.coverage = surface.opacity[i];
    p.scatters = !m->unlit;
    if (lets_through(*m)) p.smooth = nullptr;
    if (m->unlit) p.emission += p.base_color;
    if (m->extensions) {
      p.behind = medium_behind(*m->extensions, scene, surface, i);
      const bool thin = is_thin_wall(*m);
      p.disperses = !thin && m->extensions->dispersion > 0.0f && m->transmission > 0.0f;
      p.is_wall = thin && m->transmission > 0.0f && mesh_record(scene, surface, i);
    }
  } else {
    // Path tracing computes the light that `ambient` stands for. Only surfaces that reflect nothing, such as backdrops, emit
    // their ambient light.
    if (surface.diffuse[i] == 0.0f) p.emission += surface.ambient.get(i) * p.base_color;
    if (!scene.tachyon) p.emission *= surface.opacity[i];
  }
  return p;
}

std::optional<MetalRoughPoint> base_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface,
                                       int i) {
  const auto* m = std::get_if<MetallicRoughness>(&material_of(scene, surface, i).surface);
  if (!m) return lambert_at(surface, i);
  if (!is_base_alone(*m)) return std::nullopt;
  return metal_rough_point(*m, surface.color.get(i), maps_at(scene, packet, surface, i), seen_point(packet, surface, i),
                           surface.color_channel[i]);
}

Bsdf bsdf_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i) {
  const SeenPoint seen = seen_point(packet, surface, i);
  const Vec3f color = surface.color.get(i);
  const auto* m = std::get_if<MetallicRoughness>(&material_of(scene, surface, i).surface);
  if (!m) {
    const float itself = scene.tachyon ? 1.0f : surface.opacity[i];  // Tachyon's diffuse term and highlight ignore the opacity
    PhongPoint p;
    p.diffuse = itself * surface.diffuse[i] * color;
    p.highlight = itself * surface.highlight[i] * glm::mix(Vec3f(1.0f), color, surface.highlight_tint[i]);
    p.highlight_size = surface.highlight_size[i];
    p.mirror = surface.mirror[i] * glm::mix(Vec3f(1.0f), color, surface.mirror_tint[i]);
    p.through = 1.0f - surface.opacity[i];
    p.ior = surface.ior[i];
    return Bsdf(std::in_place_type<PhongBsdf>, p, seen.normal, seen.view, seen.entering);
  }
  return metal_rough_bsdf(*m, color, maps_at(scene, packet, surface, i), scene.path->albedo, seen, surface.color_channel[i]);
}

}  // namespace lippmann
