#include "shading/shaded_scene.hpp"

#include "shading/look_up.hpp"

namespace lippmann {
namespace {

/// What lights shapes from all around, where that is not traced. Of a gradient: between its ends.
Vec3f surroundings(const Scene& scene, const Environment& environment) {
  const Background& b = scene.background;
  return b.map ? environment.mean_radiance() : 0.5f * (b.horizon + b.zenith);
}

/// A mesh with alpha, or whose material lets light pass.
class MeshShadow final : public ShadowCaster {
 public:
  /// color: whose alpha counts; null: none.
  MeshShadow(const WhittedMaterial& material, const Mesh& mesh, const DeviceTexture* color)
      : material_(material), mesh_(mesh), color_(color) {}

  float transmittance(std::uint32_t triangle, Vec2f barycentric) const override {
    if (!material_.has_alpha) return shadow_transmittance(material_);
    float alpha = material_.opacity;
    const std::vector<Vec2f>& uvs = uvs_of(mesh_, material_.color_map.uv_set);
    if (color_ && !uvs.empty()) {
      const Vec2f uv = interpolate(uvs, mesh_.triangles[triangle], barycentric);
      alpha *= sample_point(*color_, material_.color_map.offset + material_.color_map.matrix * uv).a;
    }
    if (!mesh_.alphas.empty()) alpha *= interpolate(mesh_.alphas, mesh_.triangles[triangle], barycentric);
    if (material_.alpha_cutoff > 0.0f) return material_.base_alpha * alpha >= material_.alpha_cutoff ? 0.0f : 1.0f;
    return std::clamp(1.0f - alpha, 0.0f, 1.0f);
  }

 private:
  const WhittedMaterial& material_;
  const Mesh& mesh_;
  const DeviceTexture* color_;
};

}  // namespace

ShadingTables::ShadingTables(const Scene& scene, const ResolvedScene& resolved, MaterialUse use, const ThreadPool& pool)
    : lights(make_lights(scene, resolved)), environment(std::make_unique<Environment>(scene.background)) {
  materials = make_material_table(scene, surroundings(scene, *environment), use);
  if (use == MaterialUse::kPaths) {
    path = std::make_unique<PathTables>();
    path->media = Media(scene);
  }
  material_of_instance.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances)
    material_of_instance.push_back(static_cast<std::uint32_t>(instance.material));
  const bool tachyon = scene.encoding == Encoding::kTachyonTruncate;
  textures.resize(scene.textures.size());
  pool.for_each(textures.size(), [&](std::size_t t) { textures[t] = make_device_texture(scene.textures[t], tachyon); });
}

float ShadingTables::transmittance(std::uint32_t instance) const {
  return shadow_transmittance(materials.materials[material_of_instance[instance]]);
}

std::unique_ptr<ShadowCaster> ShadingTables::caster(std::uint32_t instance, const Mesh& mesh) const {
  const WhittedMaterial& material = materials.materials[material_of_instance[instance]];
  if (!material.has_alpha && !(shadow_transmittance(material) > 0.0f)) return nullptr;
  const int color = material.color_map.texture;
  return std::make_unique<MeshShadow>(material, mesh, color >= 0 ? &textures[static_cast<std::size_t>(color)] : nullptr);
}

ShadedScene::ShadedScene(const Scene& described, const ThreadPool& pool, MaterialUse use)
    : ShadedScene(described, evaluate(described, described.timeline.time(0)), pool, use) {}

ShadedScene::ShadedScene(const Scene& described, const ResolvedScene& resolved, const ThreadPool& pool, MaterialUse use)
    : ShadingTables(described, resolved, use, pool),
      RayScene(described, resolved, static_cast<const ShadowMaterials&>(*this), pool) {
  tabulate_lights();
}

void ShadedScene::update(const ResolvedScene& resolved, const ThreadPool& pool) {
  lights = make_lights(*scene, resolved);
  RayScene::update(resolved, pool);
  tabulate_lights();
}

/// The lights of this frame, for paths.
void ShadedScene::tabulate_lights() {
  if (path)
    path->lights = std::make_unique<LightTable>(LightSources{*scene, lights, records, materials.materials, textures, radius},
                                                *environment);
}

}  // namespace lippmann
