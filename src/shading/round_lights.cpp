#include "shading/round_lights.hpp"

#include <algorithm>

#include "device/lanes.hpp"
#include "device/primitives.hpp"
#include "device/ray_packet.hpp"
#include "scene/photometric_web.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

/// Smaller lamps are treated as points, because their penumbra would be narrower than the offset of shadow rays.
constexpr float kLeastRadius = 1e-5f;  // relative to half the scene's diagonal
constexpr float kLeastHalfAngle = 2e-5f;

/// The cone of directions from a point to a lamp. one_minus_cos is 1 minus the cosine of the half angle: at most 1 outside a
/// spherical lamp, and 2 inside.
struct Cone {
  Vec3f axis;
  float one_minus_cos;
  float density() const { return 1.0f / (2.0f * kPi * one_minus_cos); }
};

float one_minus_cos(float squared_sine) { return squared_sine / (1.0f + std::sqrt(1.0f - squared_sine)); }

Cone cone_of_sphere(const WhittedLight& light, Vec3f from) {
  const Vec3f to = light.position - from;
  const float squared = glm::dot(to, to), radius_squared = light.radius * light.radius;
  if (!(squared > radius_squared)) return {Vec3f(0.0f, 0.0f, 1.0f), 2.0f};
  return {to / std::sqrt(squared), one_minus_cos(radius_squared / squared)};
}

Cone cone_of(const WhittedLight& light, Vec3f from) {
  if (light.at_place > 0.0f) return cone_of_sphere(light, from);
  const float sine = std::sin(light.half_angle);
  return {light.toward, one_minus_cos(std::min(sine * sine, 1.0f))};
}

Vec3f direction_in(const Cone& cone, Vec2f u) {
  const Vec2f d = sample_disc(u);  // d is uniform in the disc, so |d|^2 is uniform in [0, 1]
  const float share = std::min(glm::dot(d, d), 1.0f), height = cone.one_minus_cos * share;
  // `height` is 1 minus the cosine between the direction and the axis, so the sine is sqrt(height (2 - height)).
  const float scale = std::sqrt(std::max(0.0f, cone.one_minus_cos * (2.0f - height)));
  return glm::normalize(Basis(cone.axis).to_world({scale * d.x, scale * d.y, 1.0f - height}));
}

float way_to(const WhittedLight& light, Vec3f from, Vec3f direction, bool is_within) {
  const WorldSphere ball{light.position.x, light.position.y, light.position.z, light.radius};
  const auto [middle, discriminant] =
      crossing(ball, {from.x, from.y, from.z, direction.x, direction.y, direction.z, 0.0f, kInfinity});
  const float half = std::sqrt(std::max(discriminant, 0.0f));
  return std::max(0.0f, is_within ? middle + half : middle - half);
}

std::optional<LightSample> light_along(const WhittedLight& light, float unit, Vec3f from, Vec3f direction, const Cone& cone) {
  LightSample sample{direction, kInfinity, unit * light.color, cone.density(), true};
  if (light.at_place > 0.0f) {
    if (glm::length(light.position - from) > light.range) return std::nullopt;
    const float fades = fading(light, direction);
    if (!(fades > 0.0f)) return std::nullopt;
    sample.radiance *= fades / (kPi * light.radius * light.radius);
    sample.distance = way_to(light, from, direction, cone.one_minus_cos > 1.0f);
  } else {
    const float sine = std::sin(light.half_angle);
    sample.radiance /= kPi * sine * sine;
  }
  return sample;
}

bool sees_disc(const WhittedLight& light, Vec3f direction) {
  const Vec3f across = glm::cross(direction, light.toward);
  const float sine = std::sin(light.half_angle);
  return glm::dot(direction, light.toward) > 0.0f && glm::dot(across, across) < sine * sine;
}

bool sees_sphere(const WhittedLight& light, Vec3f from, Vec3f direction, bool is_within) {
  if (is_within) return true;
  const WorldSphere ball{light.position.x, light.position.y, light.position.z, light.radius};
  const auto [middle, discriminant] =
      crossing(ball, {from.x, from.y, from.z, direction.x, direction.y, direction.z, 0.0f, kInfinity});
  return middle > 0.0f && discriminant > 0.0f;
}

}  // namespace

float fading(const WhittedLight& light, Vec3f direction) {
  if (light.web) return intensity(*light.web, light.light_from_world * -direction);
  const float cosine = glm::dot(direction, light.toward);
  if (light.has_cone > 0.0f) {
    const float ramp = std::clamp((cosine - light.cos_outer) * light.inverse_ramp, 0.0f, 1.0f);
    return ramp * ramp * (1.0f + light.has_smooth_edge * (2.0f - 2.0f * ramp));
  }
  if (!light.linear_cone) return 1.0f;
  const float angle = std::acos(std::clamp(cosine, -1.0f, 1.0f));
  if (angle > light.outer_cone) return 0.0f;
  return angle > light.inner_cone ? 1.0f - (angle - light.inner_cone) / (light.outer_cone - light.inner_cone) : 1.0f;
}

bool is_round(const WhittedLight& light, float scene_size) {
  return light.radius > kLeastRadius * scene_size || light.half_angle > kLeastHalfAngle;
}

LIPPMANN_MULTIVERSION bool is_pointed_at(const WhittedLight& light, const RayPacket& rays) {
  if (!(light.at_place > 0.0f)) return true;
  const WorldSphere ball{light.position.x, light.position.y, light.position.z, light.radius};
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    const LaneRay ray{rays.org_x[i], rays.org_y[i], rays.org_z[i], rays.dir_x[i],
                      rays.dir_y[i], rays.dir_z[i], 0.0f,          kInfinity};
    any |= discriminant(ball, ray) >= 0.0f ? -1 : 0;
  }
  return any != 0;
}

std::optional<LightSample> sample_round(const WhittedLight& light, float unit, Vec3f from, Vec2f u) {
  const Cone cone = cone_of(light, from);
  return light_along(light, unit, from, direction_in(cone, u), cone);
}

std::optional<LightSample> see_round(const WhittedLight& light, float unit, Vec3f from, Vec3f direction) {
  const Cone cone = cone_of(light, from);
  const bool sees =
      light.at_place > 0.0f ? sees_sphere(light, from, direction, cone.one_minus_cos > 1.0f) : sees_disc(light, direction);
  return sees ? light_along(light, unit, from, direction, cone) : std::nullopt;
}

}  // namespace lippmann
