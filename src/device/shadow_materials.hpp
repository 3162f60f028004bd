// The interface through which shadow rays find out how much light passes straight through surfaces.
#pragma once

#include <cstdint>
#include <memory>

#include "device/scene_geometry.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// A hit of a shadow ray on a mesh.
struct ShadowHit {
  const GeometryRecord& record;
  std::uint32_t triangle;
  Vec2f barycentric;  ///< weights of the triangle's second and third corner
  Vec3f facet;        ///< normal of the facet on the outer side, in mesh space, any length
  Vec3f direction;    ///< direction of the ray, towards the light, in world space
};

/// The transmittance of a mesh that is not fully opaque. Thread-safe.
class ShadowCaster {
 public:
  virtual ~ShadowCaster() = default;
  /// Returns the share of red, green and blue light that passes. 0 ends the ray.
  virtual Vec3f transmittance(const ShadowHit& hit) const = 0;
};

class ShadowMaterials {
 public:
  virtual ~ShadowMaterials() = default;
  /// Returns the transmittance of an instance's whole surface; 0: opaque.
  virtual float transmittance(std::uint32_t instance) const = 0;
  /// Returns the caster of an instance of a mesh, or null if it is opaque.
  virtual std::unique_ptr<ShadowCaster> caster(std::uint32_t instance) const = 0;
};

}  // namespace lippmann
