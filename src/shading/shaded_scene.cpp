#include "shading/shaded_scene.hpp"

#include <utility>

#include "shading/mesh_shadow.hpp"

namespace lippmann {
namespace {

/// Returns the ambient light for surfaces whose surroundings are not traced: the mean of a panorama, or the middle of a
/// gradient.
Vec3f surroundings(const Scene& scene, const Environment& environment) {
  const Background& b = scene.background;
  return b.map ? environment.mean_radiance() : 0.5f * (b.horizon + b.zenith);
}

}  // namespace

ShadingTables::ShadingTables(const Scene& scene, const ResolvedScene& resolved, MaterialUse use, const ThreadPool& pool)
    : lights(make_lights(scene, resolved)),
      environment(std::make_unique<Environment>(scene.background)),
      described_materials_(scene.materials) {
  materials = make_material_table(scene, surroundings(scene, *environment), use);
  if (use == MaterialUse::kPaths) {
    path = std::make_unique<PathTables>();
    path->media = Media(scene);
    path->beams = beams_of(scene.webs);
  }
  material_of_instance.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances)
    material_of_instance.push_back(static_cast<std::uint32_t>(instance.material));
  const bool tachyon = scene.encoding == Encoding::kTachyonTruncate;
  textures.resize(scene.textures.size());
  pool.for_each(textures.size(), [&](std::size_t t) { textures[t] = make_device_texture(scene.textures[t], tachyon); });
  if (path) path->emitters = Emitters(scene, materials.materials, textures, pool);
}

float ShadingTables::transmittance(std::uint32_t instance) const {
  return shadow_transmittance(materials.materials[material_of_instance[instance]]);
}

std::unique_ptr<ShadowCaster> ShadingTables::caster(std::uint32_t instance) const {
  const std::uint32_t material = material_of_instance[instance];
  return make_mesh_shadow(*this, materials.materials[material], described_materials_[material]);
}

ShadedScene::ShadedScene(const Scene& described, const ThreadPool& pool, MaterialUse use)
    : ShadedScene(described, evaluate(described, described.timeline.time(0)), pool, use) {}

ShadedScene::ShadedScene(const Scene& described, const ResolvedScene& resolved, const ThreadPool& pool, MaterialUse use)
    : ShadingTables(described, resolved, use, pool),
      RayScene(described, resolved, static_cast<const ShadowMaterials&>(*this), pool) {
  tabulate_lights();
}

void ShadedScene::update(const ResolvedScene& resolved, const ThreadPool& pool) {
  std::vector<WhittedLight> moved = make_lights(*scene, resolved);
  const bool stands = moved == lights && !any_emitter_moves();
  if (!stands) lights = std::move(moved);  // otherwise `lights` must not be replaced, because the light table refers to it
  RayScene::update(resolved, pool);
  if (!stands) tabulate_lights();
}

bool ShadedScene::any_emitter_moves() const {
  for (std::size_t i = 0; path && i < instance_moves.size(); ++i)
    if (instance_moves[i] && path->emitters.of(i)) return true;
  return false;
}

/// Building a light tree for a million lights takes seconds, so update() calls this only if a light has moved.
void ShadedScene::tabulate_lights() {
  if (path)
    path->lights = std::make_unique<LightTable>(
        LightSources{*scene, lights, records, materials.materials, textures, path->emitters, path->beams, radius},
        *environment);
}

}  // namespace lippmann
