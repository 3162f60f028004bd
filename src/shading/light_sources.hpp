#pragma once

#include <span>

#include "shading/emitters.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

struct GeometryRecord;

struct LightSources {
  const Scene& scene;
  std::span<const WhittedLight> lights;
  std::span<const GeometryRecord> records;
  std::span<const WhittedMaterial> materials;
  std::span<const DeviceTexture> textures;
  const Emitters& emitters;
  std::span<const WebBeam> beams;
  float size;  ///< half the scene's diagonal; lamps much smaller than this are treated as points
};

}  // namespace lippmann
