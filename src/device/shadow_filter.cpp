#include "device/shadow_filter.hpp"

namespace lippmann {
namespace {

/// Returns the hit of ray i. For placed meshes, Embree passes the ray in mesh space.
ShadowHit shadow_hit(const RTCFilterFunctionNArguments* args, const SceneGeometry& geometry, unsigned i) {
  const unsigned placed = RTCHitN_instID(args->hit, args->N, i, 0);
  const GeometryRecord& record = geometry.records[placed != kNoId ? placed : RTCHitN_geomID(args->hit, args->N, i)];
  const Vec3f direction(RTCRayN_dir_x(args->ray, args->N, i), RTCRayN_dir_y(args->ray, args->N, i),
                        RTCRayN_dir_z(args->ray, args->N, i));
  return {record,
          RTCHitN_primID(args->hit, args->N, i),
          {RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i)},
          {RTCHitN_Ng_x(args->hit, args->N, i), RTCHitN_Ng_y(args->hit, args->N, i), RTCHitN_Ng_z(args->hit, args->N, i)},
          record.placed ? record.world_from_mesh.linear * direction : direction};
}

void weaken(ShadowContext& context, unsigned lane, Vec3f passes) {
  if (passes.x == passes.y && passes.y == passes.z) {
    context.transmittance[lane] *= passes.x;
    return;
  }
  if (!context.is_tinted)
    for (int i = 0; i < kLanes; ++i) context.tint.set(i, Vec3f(1.0f));
  context.is_tinted = true;
  const int i = static_cast<int>(lane);
  context.tint.set(i, context.tint.get(i) * passes);
}

void weaken_shadow(const RTCFilterFunctionNArguments* args) {
  const auto& caster = *static_cast<const ShadowCaster*>(args->geometryUserPtr);
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    const Vec3f passes = caster.transmittance(shadow_hit(args, *context->geometry, i));
    if (!(passes.x + passes.y + passes.z > 0.0f)) continue;  // no light passes, so the ray ends here
    weaken(*context, RTCRayN_id(args->ray, args->N, i), passes);
    args->valid[i] = 0;
  }
}

}  // namespace

void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster) {
  rtcSetGeometryUserData(geometry, const_cast<ShadowCaster*>(&caster));
  rtcSetGeometryOccludedFilterFunction(geometry, weaken_shadow);
}

}  // namespace lippmann
