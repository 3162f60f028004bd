#include "device/shadow_filter.hpp"

namespace lippmann {
namespace {

/// Ray ids are lanes.
void weaken_shadow(const RTCFilterFunctionNArguments* args) {
  const auto& caster = *static_cast<const ShadowCaster*>(args->geometryUserPtr);
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    const Vec2f at(RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
    const float passes = caster.transmittance(RTCHitN_primID(args->hit, args->N, i), at);
    if (!(passes > 0.0f)) continue;  // opaque: the ray ends here
    context->transmittance[RTCRayN_id(args->ray, args->N, i)] *= passes;
    args->valid[i] = 0;
  }
}

}  // namespace

void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster) {
  rtcSetGeometryUserData(geometry, const_cast<ShadowCaster*>(&caster));
  rtcSetGeometryOccludedFilterFunction(geometry, weaken_shadow);
}

}  // namespace lippmann
