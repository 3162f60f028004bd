// The inputs of a scene's light table.
#pragma once

#include <span>

#include "shading/emitters.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

struct GeometryRecord;

/// The referenced data must outlive the light table.
struct LightSources {
  const Scene& scene;
  std::span<const WhittedLight> lights;
  std::span<const GeometryRecord> records;
  std::span<const WhittedMaterial> materials;
  std::span<const DeviceTexture> textures;
  const Emitters& emitters;
  std::span<const WebBeam> beams;  ///< one beam per photometric web, in the order of scene.webs
  float size;                      ///< half the scene's diagonal; lamps much smaller than this are treated as points
};

}  // namespace lippmann
