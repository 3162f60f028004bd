// What the device has to know of materials: how much light their surfaces let pass on its straight way.
#pragma once

#include <cstdint>
#include <memory>

#include "device/scene_geometry.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Where a shadow ray meets a mesh.
struct ShadowHit {
  const GeometryRecord& record;
  std::uint32_t triangle;
  Vec2f barycentric;  ///< weights of the triangle's second and third corners
  Vec3f facet;        ///< its normal on the outer side, in the space of the record's mesh, of any length
  Vec3f direction;    ///< the ray's, towards the light, in world space
};

/// What a mesh that is not opaque everywhere lets through. Thread-safe.
class ShadowCaster {
 public:
  virtual ~ShadowCaster() = default;
  /// The share of red, green and blue light that passes; 0: light ends there.
  virtual Vec3f transmittance(const ShadowHit& hit) const = 0;
};

class ShadowMaterials {
 public:
  virtual ~ShadowMaterials() = default;
  /// What an instance's whole surface lets through; 0: opaque.
  virtual float transmittance(std::uint32_t instance) const = 0;
  /// For an instance that shows a mesh; null: opaque.
  virtual std::unique_ptr<ShadowCaster> caster(std::uint32_t instance) const = 0;
};

}  // namespace lippmann
