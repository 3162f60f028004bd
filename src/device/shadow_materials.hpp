// The interface by which shadow rays get the transmittance of surfaces.
#pragma once

#include <cstdint>
#include <memory>

#include "device/scene_geometry.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct ShadowHit {
  const GeometryRecord& record;
  std::uint32_t triangle;
  Vec2f barycentric;  ///< weights of the triangle's second and third corner
  Vec3f facet;        ///< normal of the facet on the outer side, in mesh space, any length
  Vec3f direction;    ///< direction of the ray in world space, from the surface to the light
};

class ShadowCaster {
 public:
  virtual ~ShadowCaster() = default;
  /// Returns the transmittance of red, green and blue light. If all are 0, the ray ends.
  virtual Vec3f transmittance(const ShadowHit& hit) const = 0;
};

class ShadowMaterials {
 public:
  virtual ~ShadowMaterials() = default;
  virtual float transmittance(std::uint32_t instance) const = 0;
  virtual std::unique_ptr<ShadowCaster> caster(std::uint32_t instance) const = 0;
};

}  // namespace lippmann
