#pragma once

#include <memory>
#include <span>
#include <vector>

#include "device/ray_scene.hpp"
#include "shading/emitters.hpp"
#include "shading/light_table.hpp"
#include "shading/materials.hpp"
#include "shading/media.hpp"
#include "shading/texture.hpp"
#include "transport/environment.hpp"
#include "transport/ggx_albedo.hpp"

namespace lippmann {

/// Tables that only path tracing uses.
struct PathTables {
  GgxAlbedo albedo;
  Media media;
  Emitters emitters;
  std::vector<WebBeam> beams;
  std::unique_ptr<LightTable> lights;
};

struct ShadingTables : ShadowMaterials {
  ShadingTables(const Scene& scene, const ResolvedScene& resolved, MaterialUse use, const ThreadPool& pool);

  float transmittance(std::uint32_t instance) const override;
  std::unique_ptr<ShadowCaster> caster(std::uint32_t instance) const override;

  MaterialTable materials;
  std::vector<std::uint32_t> material_of_instance;
  std::vector<WhittedLight> lights;
  std::unique_ptr<Environment> environment;
  std::unique_ptr<PathTables> path;
  std::vector<DeviceTexture> textures;

 private:
  std::span<const Material> described_materials_;
};

struct ShadedScene : ShadingTables, RayScene {
  /// Starts at the first frame of the timeline. `scene` must outlive this object.
  ShadedScene(const Scene& scene, const ThreadPool& pool, MaterialUse use);

  void update(const ResolvedScene& resolved, const ThreadPool& pool);

 private:
  ShadedScene(const Scene& scene, const ResolvedScene& resolved, const ThreadPool& pool, MaterialUse use);
  bool any_emitter_moves() const;
  void tabulate_lights();
};

}  // namespace lippmann
