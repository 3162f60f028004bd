// Shadow rays and BSDF samples must have the same transmittance through a thin wall, as multiple importance sampling requires.
#include "shading/mesh_shadow.hpp"

#include "shading/look_up.hpp"
#include "shading/shaded_scene.hpp"
#include "shading/surface_bsdf.hpp"
#include "transport/microfacet.hpp"

namespace lippmann {
namespace {

class OpenMesh : public ShadowCaster {
 public:
  OpenMesh(const ShadingTables& tables, const WhittedMaterial& material) : tables_(tables), material_(material) {}

  Vec3f transmittance(const ShadowHit& hit) const override { return Vec3f(open(hit, material_.opacity)); }

 protected:
  float open(const ShadowHit& hit, float opacity) const {
    if (!material_.has_alpha) return material_.blocks_light ? 0.0f : std::clamp(1.0f - opacity, 0.0f, 1.0f);
    const Mesh& mesh = *hit.record.mesh;
    float alpha = opacity * look_up(material_.color_map, tables_.textures, mesh, hit.triangle, hit.barycentric).a;
    if (!mesh.alphas.empty()) alpha *= interpolate(mesh.alphas, mesh.triangles[hit.triangle], hit.barycentric);
    if (material_.alpha_cutoff > 0.0f) return material_.base_alpha * alpha >= material_.alpha_cutoff ? 0.0f : 1.0f;
    return std::clamp(1.0f - alpha, 0.0f, 1.0f);
  }

  const ShadingTables& tables_;
  const WhittedMaterial& material_;
};

class WallMesh final : public OpenMesh {
 public:
  WallMesh(const ShadingTables& tables, const WhittedMaterial& material, const MetallicRoughness& wall)
      : OpenMesh(tables, material), wall_(wall) {}

  Vec3f transmittance(const ShadowHit& hit) const override {
    const float open_share = open(hit, wall_.blend ? wall_.base_color.a : 1.0f);
    return open_share < 1.0f ? open_share + (1.0f - open_share) * straight(hit) : Vec3f(1.0f);
  }

 private:
  Vec3f straight(const ShadowHit& hit) const {
    const SeenPoint point = seen(hit);
    const Vec3f color = color_at(hit);
    if (!tables_.path) return wall_.transmission * passes_wall(material_, color, glm::dot(point.normal, point.view));
    const Maps maps{tables_.textures, &hit.record, hit.triangle, hit.barycentric};
    return metal_rough_bsdf(wall_, color, maps, tables_.path->albedo, point, 0).straight();
  }

  static SeenPoint seen(const ShadowHit& hit) {
    const Mesh& mesh = *hit.record.mesh;
    const Vec3f facet = hit.record.normal_from_mesh * hit.facet;
    const bool behind = glm::dot(facet, hit.direction) > 0.0f;
    const Vec3f smooth =
        mesh.normals.empty() ? hit.facet : interpolate(mesh.normals, mesh.triangles[hit.triangle], hit.barycentric);
    const Vec3f normal = glm::normalize(hit.record.normal_from_mesh * smooth);
    return {behind ? -normal : normal, -hit.direction, !behind, behind ? -facet : facet};
  }

  Vec3f color_at(const ShadowHit& hit) const {
    const Mesh& mesh = *hit.record.mesh;
    const Vec3f color =
        material_.color * Vec3f(look_up(material_.color_map, tables_.textures, mesh, hit.triangle, hit.barycentric));
    return mesh.colors.empty() ? color : color * interpolate(mesh.colors, mesh.triangles[hit.triangle], hit.barycentric);
  }

  const MetallicRoughness& wall_;
};

bool lets_light_straight_on(const MetallicRoughness& wall, bool of_paths) {
  return !of_paths || wall.metallic_roughness_map.texture >= 0 || squared(wall.roughness) < kSmoothAlpha;
}

}  // namespace

Vec3f passes_wall(const WhittedMaterial& wall, Vec3f color, float cosine) {
  return (1.0f - fresnel_dielectric(std::abs(cosine), wall.wall_ior)) * glm::clamp(color, Vec3f(0.0f), Vec3f(1.0f));
}

std::unique_ptr<ShadowCaster> make_mesh_shadow(const ShadingTables& tables, const WhittedMaterial& material,
                                               const Material& described) {
  if (material.wall_ior > 0.0f) {
    const auto& wall = std::get<MetallicRoughness>(described.surface);
    if (lets_light_straight_on(wall, tables.path != nullptr)) return std::make_unique<WallMesh>(tables, material, wall);
  }
  if (!material.has_alpha && !(shadow_transmittance(material) > 0.0f)) return nullptr;
  return std::make_unique<OpenMesh>(tables, material);
}

}  // namespace lippmann
