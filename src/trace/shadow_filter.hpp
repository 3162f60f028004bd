// How much light passes a mesh that is not opaque everywhere: what Embree asks at every hit of a shadow ray. Private to
// src/trace.
#pragma once

#include "trace/embree_shim.hpp"
#include "trace/materials.hpp"
#include "trace/texture.hpp"

namespace lippmann {

/// What a geometry's shadow depends on; all must outlive the geometry.
struct ShadowCaster {
  const WhittedMaterial* material;
  const Mesh* mesh;
  const DeviceTexture* color;  ///< whose alpha counts; null: none

  /// Whether rays have to ask at all.
  bool lets_light_pass() const { return material->has_alpha || shadow_transmittance(*material) > 0.0f; }
  /// At a point of a triangle, its second and third corners' barycentric coordinates given.
  float transmittance(std::uint32_t triangle, Vec2f barycentric) const;
};

/// Makes shadow rays ask `caster`: they are weakened (ShadowContext), and ended only where nothing passes.
void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster);

}  // namespace lippmann
