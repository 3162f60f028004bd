// A scene as rays meet it, with what surfaces and lights look like there.
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

/// What only paths ask for.
struct PathTables {
  GgxAlbedo albedo;
  Media media;
  Emitters emitters;
  std::vector<WebBeam> beams;          ///< by web of the scene
  std::unique_ptr<LightTable> lights;  ///< the frame's lights
};

/// Materials, textures and lights, in a form that loops over lanes read.
struct ShadingTables : ShadowMaterials {
  ShadingTables(const Scene& scene, const ResolvedScene& resolved, MaterialUse use, const ThreadPool& pool);

  float transmittance(std::uint32_t instance) const override;
  std::unique_ptr<ShadowCaster> caster(std::uint32_t instance) const override;

  MaterialTable materials;
  std::vector<std::uint32_t> material_of_instance;
  std::vector<WhittedLight> lights;
  std::unique_ptr<Environment> environment;
  std::unique_ptr<PathTables> path;  ///< null: made for Whitted's shading
  std::vector<DeviceTexture> textures;

 private:
  std::span<const Material> described_materials_;
};

/// Kernels of shading read both parts of it. Rays know nothing of how they are shaded, but for what lets shadow rays pass.
struct ShadedScene : ShadingTables, RayScene {
  /// Shows the timeline's first moment; `scene` outlives it.
  ShadedScene(const Scene& scene, const ThreadPool& pool, MaterialUse use);

  /// Moves everything to where `resolved` has it.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

 private:
  ShadedScene(const Scene& scene, const ResolvedScene& resolved, const ThreadPool& pool, MaterialUse use);
  bool any_emitter_moves() const;
  void tabulate_lights();
};

}  // namespace lippmann
