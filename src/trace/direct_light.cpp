#include "trace/direct_light.hpp"

#include "trace/fast_math.hpp"

namespace lippmann {
namespace {

/// A light as numbers that stand for its cases, so that the loop over lanes has no branches: every factor is 0 or 1.
struct AimedLight {
  float x, y, z;        ///< position
  float dx, dy, dz;     ///< towards a directional light, unit length
  float at_place;       ///< 1: point or spot light at the position, 0: directional
  float falls_off;      ///< 1: by the squared distance
  float range, beyond;  ///< beyond: added to the shadow ray's length; infinite for directional lights
  float has_cone, cos_outer, inverse_ramp;
};

AimedLight aimed(const WhittedLight& light) {
  const bool directional = light.kind == LightKind::kDirectional;
  const float nothing = 0.0f;
  return {light.position.x,
          light.position.y,
          light.position.z,
          -light.direction.x,
          -light.direction.y,
          -light.direction.z,
          directional ? nothing : 1.0f,
          light.inverse_square && !directional ? 1.0f : nothing,
          directional ? kInfinity : light.range,
          directional ? kInfinity : nothing,
          light.kind == LightKind::kSpot && !light.linear_cone ? 1.0f : nothing,
          light.cos_outer,
          1.0f / std::max(light.cos_inner - light.cos_outer, 1e-6f)};
}

/// Weakens by Tachyon's cone: linear in the angle. Apart from at_point, because it does not vectorise.
void dim_by_angle(const WhittedLight& light, ShadowPacket& shadow) {
  for (int i = 0; i < kLanes; ++i) {
    const Vec3f to_light(shadow.rays.dir_x[i], shadow.rays.dir_y[i], shadow.rays.dir_z[i]);
    const float angle = std::acos(std::clamp(-glm::dot(to_light, light.direction), -1.0f, 1.0f));
    if (angle > light.outer_cone)
      shadow.strength[i] = 0.0f;
    else if (angle > light.inner_cone)
      shadow.strength[i] *= 1.0f - (angle - light.inner_cone) / (light.outer_cone - light.inner_cone);
  }
}

/// Weakens by Tachyon's attenuation. Apart from at_point, because few lights have it.
void dim_by_distance(const WhittedLight& light, ShadowPacket& shadow) {
  const Vec3f a = light.attenuation;
  for (int i = 0; i < kLanes; ++i) {
    const float d = shadow.rays.tfar[i];
    shadow.strength[i] /= a.x + (a.y + a.z * d) * d;
  }
}

LIPPMANN_MULTIVERSION void read_visibility(const ShadowContext& context, ShadowPacket& shadow) {
  LIPPMANN_FOR_LANES(i) {
    const bool lit = (shadow.active.lane[i] != 0) & (shadow.rays.tfar[i] >= 0.0f);
    shadow.visibility[i] = lit ? context.transmittance[i] : 0.0f;
  }
}

LIPPMANN_MULTIVERSION int still_lit(const ShadowPacket& shadow, LaneMask& lit) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    lit.lane[i] = (shadow.active.lane[i] != 0) & (shadow.rays.tfar[i] >= 0.0f) ? -1 : 0;
    any |= lit.lane[i];
  }
  return any;
}

LIPPMANN_MULTIVERSION void add_diffuse(Vec3f light_color, const ShadowPacket& shadow, DirectLight& direct) {
  LIPPMANN_FOR_LANES(i) {
    const float weight = shadow.cosine[i] * shadow.strength[i] * shadow.visibility[i];
    const float arriving = shadow.visibility[i] > 0.0f ? weight : 0.0f;
    direct.diffuse.x[i] += light_color.x * arriving;
    direct.diffuse.y[i] += light_color.y * arriving;
    direct.diffuse.z[i] += light_color.z * arriving;
  }
}

/// Whether N.H passes the cutoff in any lit lane: without root, quotient or power, as most packets have no highlight.
LIPPMANN_MULTIVERSION int highlight_shows(const SurfacePacket& s, const RTCRay16& view, const ShadowPacket& shadow) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    const float hx = shadow.rays.dir_x[i] - view.dir_x[i], hy = shadow.rays.dir_y[i] - view.dir_y[i],
                hz = shadow.rays.dir_z[i] - view.dir_z[i];
    const float along = s.normal.x[i] * hx + s.normal.y[i] * hy + s.normal.z[i] * hz;
    const float limit = s.highlight_cutoff[i] * s.highlight_cutoff[i] * (hx * hx + hy * hy + hz * hz);
    any |= (shadow.visibility[i] > 0.0f) & (along > 0.0f) & (along * along > limit) ? -1 : 0;
  }
  return any;
}

LIPPMANN_MULTIVERSION void add_highlight(Vec3f light_color, const SurfacePacket& s, const RTCRay16& view,
                                         const ShadowPacket& shadow, bool tachyon, DirectLight& direct) {
  const float whole = tachyon ? 1.0f : 0.0f;
  LIPPMANN_FOR_LANES(i) {
    const float hx = shadow.rays.dir_x[i] - view.dir_x[i], hy = shadow.rays.dir_y[i] - view.dir_y[i],
                hz = shadow.rays.dir_z[i] - view.dir_z[i];
    const float length = std::sqrt(hx * hx + hy * hy + hz * hz) + 1e-20f;
    const float n_h = (s.normal.x[i] * hx + s.normal.y[i] * hy + s.normal.z[i] * hz) / length;
    const float base = std::min(std::max(n_h, 1e-6f), 1.0f);
    const float lobe = s.highlight[i] * fast_exp2(s.highlight_size[i] * fast_log2(base));
    const float dimmed = shadow.strength[i] * shadow.visibility[i];
    const float shows = (shadow.visibility[i] > 0.0f ? 1.0f : 0.0f) * (n_h > s.highlight_cutoff[i] ? 1.0f : 0.0f);
    const float arriving = shows * lobe * (dimmed + whole * (1.0f - dimmed));
    const float white = whole * s.highlight_tint[i];
    direct.highlight.x[i] += (light_color.x + white * (1.0f - light_color.x)) * arriving;
    direct.highlight.y[i] += (light_color.y + white * (1.0f - light_color.y)) * arriving;
    direct.highlight.z[i] += (light_color.z + white * (1.0f - light_color.z)) * arriving;
  }
}

LIPPMANN_MULTIVERSION void aim(const AimedLight l, const SurfacePacket& s, ShadowPacket& shadow) {
  const float bx = (1.0f - l.at_place) * l.dx, by = (1.0f - l.at_place) * l.dy, bz = (1.0f - l.at_place) * l.dz;
  LIPPMANN_FOR_LANES(i) {
    const float px = s.position.x[i], py = s.position.y[i], pz = s.position.z[i];
    const float lx = l.at_place * (l.x - px) + bx, ly = l.at_place * (l.y - py) + by, lz = l.at_place * (l.z - pz) + bz;
    const float distance = std::sqrt(lx * lx + ly * ly + lz * lz), inverse = 1.0f / (distance + 1e-20f);
    const float ux = lx * inverse, uy = ly * inverse, uz = lz * inverse;
    const float ramp = (ux * l.dx + uy * l.dy + uz * l.dz - l.cos_outer) * l.inverse_ramp;
    const float cone = std::min(std::max(ramp, 0.0f), 1.0f);
    const float reached = distance <= l.range ? 1.0f : 0.0f;
    shadow.strength[i] =
        reached * (1.0f + l.falls_off * (inverse * inverse - 1.0f)) * (1.0f + l.has_cone * (cone * cone - 1.0f));
    shadow.cosine[i] = s.normal.x[i] * ux + s.normal.y[i] * uy + s.normal.z[i] * uz;
    shadow.rays.org_x[i] = px, shadow.rays.org_y[i] = py, shadow.rays.org_z[i] = pz;
    shadow.rays.dir_x[i] = ux, shadow.rays.dir_y[i] = uy, shadow.rays.dir_z[i] = uz;
    shadow.rays.tnear[i] = s.t_near[i];
    shadow.rays.tfar[i] = distance + l.beyond;
  }
}

LIPPMANN_MULTIVERSION int choose_active(const SurfacePacket& s, float least_light, ShadowPacket& shadow) {
  int count = 0;
  LIPPMANN_FOR_LANES(i) {
    const int active = (s.hit.lane[i] != 0) & (shadow.cosine[i] * shadow.strength[i] > least_light) ? -1 : 0;
    shadow.active.lane[i] = active;
    count -= active;
  }
  return count;
}

}  // namespace

int aim_at_light(const WhittedLight& light, const SurfacePacket& surface, float least_light, ShadowPacket& shadow) {
  aim(aimed(light), surface, shadow);
  if (light.kind == LightKind::kSpot && light.linear_cone) dim_by_angle(light, shadow);
  if (light.kind != LightKind::kDirectional && light.attenuation != Vec3f(1.0f, 0.0f, 0.0f)) dim_by_distance(light, shadow);
  return choose_active(surface, least_light, shadow);
}

void trace_shadows(const DeviceScene::Impl& scene, ShadowPacket& shadow) {
  ShadowContext context;
  for (float& t : context.transmittance) t = 1.0f;
  LaneMask lit = shadow.active;
  if (!scene.planes.empty()) {
    occlude_by_planes(scene, lit, shadow.rays, context);
    if (!still_lit(shadow, lit)) return read_visibility(context, shadow);
  }
  if (scene.has_fixed) {
    occluded(scene.fixed.get(), scene.native_width, lit, shadow.rays, context);
    if (scene.has_moving && !still_lit(shadow, lit)) return read_visibility(context, shadow);
  }
  if (scene.has_moving) occluded(scene.moving.get(), scene.native_width, lit, shadow.rays, context);
  read_visibility(context, shadow);
}

void add_light(const WhittedLight& light, const SurfacePacket& surface, const RTCRay16& view, const ShadowPacket& shadow,
               bool tachyon, DirectLight& direct) {
  add_diffuse(light.color, shadow, direct);
  if (surface.any_highlight && highlight_shows(surface, view, shadow))
    add_highlight(light.color, surface, view, shadow, tachyon, direct);
}

}  // namespace lippmann
