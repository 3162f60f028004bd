// What the device has to know of materials: how much light their surfaces let pass on its straight way.
#pragma once

#include <cstdint>
#include <memory>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// What a mesh that is not opaque everywhere lets through. Thread-safe.
class ShadowCaster {
 public:
  virtual ~ShadowCaster() = default;
  /// At a point of a triangle, its second and third corners' barycentric coordinates given; 0: light ends there.
  virtual float transmittance(std::uint32_t triangle, Vec2f barycentric) const = 0;
};

class ShadowMaterials {
 public:
  virtual ~ShadowMaterials() = default;
  /// What an instance's whole surface lets through; 0: opaque.
  virtual float transmittance(std::uint32_t instance) const = 0;
  /// For an instance that `mesh` shows, which outlives it; null: opaque.
  virtual std::unique_ptr<ShadowCaster> caster(std::uint32_t instance, const Mesh& mesh) const = 0;
};

}  // namespace lippmann
