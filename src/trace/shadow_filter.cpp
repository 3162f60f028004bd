#include "trace/shadow_filter.hpp"

#include "trace/look_up.hpp"

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

float ShadowCaster::transmittance(std::uint32_t triangle, Vec2f barycentric) const {
  if (!material->has_alpha) return shadow_transmittance(*material);
  float alpha = material->opacity;
  const std::vector<Vec2f>& uvs = uvs_of(*mesh, material->color_map.uv_set);
  if (color && !uvs.empty()) {
    const Vec2f uv = interpolate(uvs, mesh->triangles[triangle], barycentric);
    alpha *= sample_point(*color, material->color_map.offset + material->color_map.matrix * uv).a;
  }
  if (!mesh->alphas.empty()) alpha *= interpolate(mesh->alphas, mesh->triangles[triangle], barycentric);
  if (material->alpha_cutoff > 0.0f) return material->base_alpha * alpha >= material->alpha_cutoff ? 0.0f : 1.0f;
  return std::clamp(1.0f - alpha, 0.0f, 1.0f);
}

void filter_shadows(RTCGeometry geometry, const ShadowCaster& caster) {
  rtcSetGeometryUserData(geometry, const_cast<ShadowCaster*>(&caster));
  rtcSetGeometryOccludedFilterFunction(geometry, weaken_shadow);
}

}  // namespace lippmann
