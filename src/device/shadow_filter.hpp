// The filter that lets shadow rays pass meshes that are not fully opaque.
#pragma once

#include "device/embree_shim.hpp"
#include "device/shadow_materials.hpp"

namespace lippmann {

/// Calls `caster` for each hit of a shadow ray with the geometry. Hits attenuate the ray (ShadowContext) and end it only at a
/// transmittance of 0. `caster` must outlive the geometry.
void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster);

}  // namespace lippmann
