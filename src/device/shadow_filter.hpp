#pragma once

#include "device/embree_shim.hpp"
#include "device/shadow_materials.hpp"

namespace lippmann {

/// Makes Embree call `caster` for each hit of a shadow ray with the geometry. A hit reduces the ray's transmittance
/// (ShadowContext), and ends the ray only if no light passes. `caster` must outlive the geometry.
void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster);

}  // namespace lippmann
