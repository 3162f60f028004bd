#include "shading/direct_light.hpp"

#include "device/fast_math.hpp"
#include "shading/light_sample.hpp"

namespace lippmann {
namespace {

LIPPMANN_INLINE void aim(const WhittedLight& light, const SurfacePacket& s, ShadowPacket& shadow) {
  const Vec3f to = light.toward, at = light.position;
  const float at_place = light.at_place, falls_off = light.falls_off, range = light.range, beyond = light.beyond;
  const float has_cone = light.has_cone, cos_outer = light.cos_outer, inverse_ramp = light.inverse_ramp;
  const float has_smooth_edge = light.has_smooth_edge;
  const float bx = (1.0f - at_place) * to.x, by = (1.0f - at_place) * to.y, bz = (1.0f - at_place) * to.z;
  LIPPMANN_FOR_LANES(i) {
    const float px = s.position.x[i], py = s.position.y[i], pz = s.position.z[i];
    const float lx = at_place * (at.x - px) + bx, ly = at_place * (at.y - py) + by, lz = at_place * (at.z - pz) + bz;
    const float distance = std::sqrt(lx * lx + ly * ly + lz * lz), inverse = 1.0f / (distance + 1e-20f);
    const float ux = lx * inverse, uy = ly * inverse, uz = lz * inverse;
    const float ramp = (ux * to.x + uy * to.y + uz * to.z - cos_outer) * inverse_ramp;
    const float cone = std::min(std::max(ramp, 0.0f), 1.0f);
    const float fading = cone * cone * (1.0f + has_smooth_edge * (2.0f - 2.0f * cone));
    const float reached = distance <= range ? 1.0f : 0.0f;
    const float strength = reached * (1.0f + falls_off * (inverse * inverse - 1.0f)) * (1.0f + has_cone * (fading - 1.0f));
    shadow.strength[i] = strength;
    shadow.arriving[i] = strength * (s.normal.x[i] * ux + s.normal.y[i] * uy + s.normal.z[i] * uz);
    shadow.rays.org_x[i] = px, shadow.rays.org_y[i] = py, shadow.rays.org_z[i] = pz;
    shadow.rays.dir_x[i] = ux, shadow.rays.dir_y[i] = uy, shadow.rays.dir_z[i] = uz;
    shadow.rays.tnear[i] = s.t_near[i];
    shadow.rays.tfar[i] = distance + beyond;
    shadow.transmittance.white[i] = 1.0f;
  }
}

LIPPMANN_INLINE void dim(ShadowPacket& shadow, int i, float factor) {
  shadow.strength[i] *= factor;
  shadow.arriving[i] *= factor;
}

/// Sets `lifted` in lanes whose light is behind the facet but in front of the smooth surface. Returns nonzero if there are any.
LIPPMANN_INLINE int find_setting(const SurfacePacket& s, ShadowPacket& shadow) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    const float behind =
        s.facet.x[i] * shadow.rays.dir_x[i] + s.facet.y[i] * shadow.rays.dir_y[i] + s.facet.z[i] * shadow.rays.dir_z[i];
    const int sets = ((s.hit.lane[i] != 0) & (behind < 0.0f) & (shadow.arriving[i] > 0.0f)) ? -1 : 0;
    shadow.lifted.lane[i] = sets;
    any |= sets;
  }
  return any;
}

void lift_rays(const SurfacePacket& s, ShadowPacket& shadow) {
  for (int i = 0; i < kLanes; ++i) {
    if (!shadow.lifted.lane[i]) continue;
    const Vec3f lift = smooth_lift(s, i);
    shadow.rays.org_x[i] += lift.x, shadow.rays.org_y[i] += lift.y, shadow.rays.org_z[i] += lift.z;
    if (lift == Vec3f(0.0f)) shadow.lifted.lane[i] = 0;
  }
}

/// Applies Tachyon's spot light cone, in which light fades linearly with the angle.
void dim_by_angle(const WhittedLight& light, ShadowPacket& shadow) {
  for (int i = 0; i < kLanes; ++i) {
    const Vec3f to_light(shadow.rays.dir_x[i], shadow.rays.dir_y[i], shadow.rays.dir_z[i]);
    const float angle = std::acos(std::clamp(glm::dot(to_light, light.toward), -1.0f, 1.0f));
    if (angle > light.outer_cone)
      dim(shadow, i, 0.0f);
    else if (angle > light.inner_cone)
      dim(shadow, i, 1.0f - (angle - light.inner_cone) / (light.outer_cone - light.inner_cone));
  }
}

void dim_by_web(const WhittedLight& light, ShadowPacket& shadow) {
  for (int i = 0; i < kLanes; ++i)
    dim(shadow, i, fading(light, {shadow.rays.dir_x[i], shadow.rays.dir_y[i], shadow.rays.dir_z[i]}));
}

/// Applies Tachyon's attenuation of point lights. tfar is the distance to the light.
LIPPMANN_INLINE void dim_by_distance(const Vec3f a, ShadowPacket& shadow) {
  LIPPMANN_FOR_LANES(i) {
    const float d = shadow.rays.tfar[i];
    dim(shadow, i, 1.0f / (a.x + (a.y + a.z * d) * d));
  }
}

LIPPMANN_INLINE int choose_active(const SurfacePacket& s, float least_light, ShadowPacket& shadow) {
  int count = 0;
  LIPPMANN_FOR_LANES(i) {
    const int active = ((s.hit.lane[i] != 0) & (shadow.arriving[i] > least_light)) ? -1 : 0;
    shadow.active.lane[i] = active;
    count -= active;
  }
  return count;
}

/// Returns whether N.H exceeds the cutoff in any lit lane. Most packets have no highlight, so this test avoids square roots,
/// divisions and powers.
LIPPMANN_INLINE int highlight_shows(const SurfacePacket& s, const RayPacket& view, const ShadowPacket& shadow,
                                    const Lanes& visibility) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    const float hx = shadow.rays.dir_x[i] - view.dir_x[i], hy = shadow.rays.dir_y[i] - view.dir_y[i],
                hz = shadow.rays.dir_z[i] - view.dir_z[i];
    const float along = s.normal.x[i] * hx + s.normal.y[i] * hy + s.normal.z[i] * hz;
    const float limit = s.highlight_cutoff[i] * s.highlight_cutoff[i] * (hx * hx + hy * hy + hz * hz);
    any |= ((visibility[i] > 0.0f) & (along > 0.0f) & (along * along > limit)) ? -1 : 0;
  }
  return any;
}

LIPPMANN_INLINE void add_highlight(const Vec3f color, const SurfacePacket& s, const RayPacket& view, const ShadowPacket& shadow,
                                   const Lanes& visibility, float whole, DirectLight& direct) {
  LIPPMANN_FOR_LANES(i) {
    const float hx = shadow.rays.dir_x[i] - view.dir_x[i], hy = shadow.rays.dir_y[i] - view.dir_y[i],
                hz = shadow.rays.dir_z[i] - view.dir_z[i];
    const float length = std::sqrt(hx * hx + hy * hy + hz * hz) + 1e-20f;
    const float n_h = (s.normal.x[i] * hx + s.normal.y[i] * hy + s.normal.z[i] * hz) / length;
    const float base = std::min(std::max(n_h, 1e-6f), 1.0f);
    const float lobe = s.highlight[i] * fast_exp2(s.highlight_size[i] * fast_log2(base));
    const float dimmed = shadow.strength[i] * visibility[i];
    const float shows = (visibility[i] > 0.0f ? 1.0f : 0.0f) * (n_h > s.highlight_cutoff[i] ? 1.0f : 0.0f);
    const float arriving = shows * lobe * (dimmed + whole * (1.0f - dimmed));
    const float white = whole * s.highlight_tint[i];
    direct.highlight.x[i] += (color.x + white * (1.0f - color.x)) * arriving;
    direct.highlight.y[i] += (color.y + white * (1.0f - color.y)) * arriving;
    direct.highlight.z[i] += (color.z + white * (1.0f - color.z)) * arriving;
  }
}

LIPPMANN_MULTIVERSION void add_untinted_light(const WhittedLight& light, const SurfacePacket& surface, const RayPacket& view,
                                              const ShadowPacket& shadow, bool tachyon, DirectLight& direct) {
  const Vec3f color = light.color;
  Lanes visibility;
  LIPPMANN_FOR_LANES(i) {
    const bool lit = (shadow.active.lane[i] != 0) & (shadow.rays.tfar[i] >= 0.0f);
    const float visible = lit ? shadow.transmittance.white[i] : 0.0f;
    const float arriving = visible > 0.0f ? shadow.arriving[i] * visible : 0.0f;
    visibility[i] = visible;
    direct.diffuse.x[i] += color.x * arriving;
    direct.diffuse.y[i] += color.y * arriving;
    direct.diffuse.z[i] += color.z * arriving;
  }
  if (surface.any_highlight && highlight_shows(surface, view, shadow, visibility))
    add_highlight(color, surface, view, shadow, visibility, tachyon ? 1.0f : 0.0f, direct);
}

/// Adds tint * light to `to` in the active lanes. `tint` is the transmittance between the light and the point.
void add_tinted(const Lanes3& tint, const LaneMask& active, const Lanes3& light, Lanes3& to) {
  for (int i = 0; i < kLanes; ++i)
    if (active.lane[i]) to.set(i, to.get(i) + tint.get(i) * light.get(i));
}

}  // namespace

LIPPMANN_MULTIVERSION int aim_at_light(const WhittedLight& light, const SurfacePacket& surface, float least_light,
                                       ShadowPacket& shadow) {
  aim(light, surface, shadow);
  shadow.any_lifted = surface.any_smooth && find_setting(surface, shadow) != 0;
  if (shadow.any_lifted) lift_rays(surface, shadow);
  if (light.linear_cone) dim_by_angle(light, shadow);
  if (light.web) dim_by_web(light, shadow);
  if (light.attenuates) dim_by_distance(light.attenuation, shadow);
  return choose_active(surface, least_light, shadow);
}

void add_light(const WhittedLight& light, const SurfacePacket& surface, const RayPacket& view, const ShadowPacket& shadow,
               bool tachyon, DirectLight& direct) {
  if (!shadow.transmittance.is_tinted) return add_untinted_light(light, surface, view, shadow, tachyon, direct);
  DirectLight untinted{};
  add_untinted_light(light, surface, view, shadow, tachyon, untinted);
  add_tinted(shadow.transmittance.tint, shadow.active, untinted.diffuse, direct.diffuse);
  add_tinted(shadow.transmittance.tint, shadow.active, untinted.highlight, direct.highlight);
}

}  // namespace lippmann
