// How shadow rays pass a mesh that is not opaque everywhere: what Embree asks at every hit.
#pragma once

#include "device/embree_shim.hpp"
#include "device/shadow_materials.hpp"

namespace lippmann {

/// Makes shadow rays ask `caster`, which outlives the geometry: they are weakened (ShadowContext), and ended only where nothing
/// passes.
void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster);

}  // namespace lippmann
