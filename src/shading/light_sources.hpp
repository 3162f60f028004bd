// The parts of a scene's table of lights.
#pragma once

#include <span>

#include "shading/emitters.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"
#include "shading/web_beams.hpp"

namespace lippmann {

struct GeometryRecord;

/// All of it must outlive the lights.
struct LightSources {
  const Scene& scene;
  std::span<const WhittedLight> lights;
  std::span<const GeometryRecord> records;
  std::span<const WhittedMaterial> materials;
  std::span<const DeviceTexture> textures;
  const Emitters& emitters;
  std::span<const WebBeam> beams;  ///< by web of the scene
  float size;                      ///< half the scene's diagonal: far smaller lamps are points
};

}  // namespace lippmann
