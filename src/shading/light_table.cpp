#include "shading/light_table.hpp"

#include <algorithm>
#include <utility>

#include "shading/round_lights.hpp"
#include "shading/tree_lights.hpp"
#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// Groups with more lamps than this are sampled by a tree instead of by power.
constexpr std::size_t kMostLampsByPower = 4;

bool has_phong(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return std::holds_alternative<PhongSurface>(m.surface); });
}

float strength(const WhittedLight& light, Vec3f direction, float distance) {
  if (distance > light.range) return 0.0f;
  float s = light.falls_off > 0.0f ? 1.0f / std::max(distance * distance, 1e-20f) : 1.0f;
  s *= fading(light, direction);
  if (light.attenuates) s /= light.attenuation.x + distance * (light.attenuation.y + distance * light.attenuation.z);
  return s;
}

/// Returns whether the irradiance of a light falls off with distance. Far lights send the same irradiance to all points of the
/// scene.
bool is_near(const WhittedLight& light) { return light.falls_off > 0.0f; }

/// Returns the flux of a near light, or the irradiance that a far light gives a surface facing it. `unit` converts light
/// colours to irradiance: pi if the scene has Phong surfaces, otherwise 1.
float power(const WhittedLight& light, float unit) {
  const float color = unit * luminance(light.color);
  return finite_power(is_near(light) ? 4.0f * kPi * color : color);
}

void add_lamp(const LightSources& sources, std::size_t lamp, float of_lamp, LightGroup& group) {
  const WhittedLight& light = sources.lights[lamp];
  group.near.push_back(is_near(light) ? of_lamp : 0.0f);
  group.far.push_back(is_near(light) ? 0.0f : of_lamp);
  const int web = sources.scene.lights[lamp].web;
  const WebBeam* beam = web < 0 ? nullptr : &sources.beams[static_cast<std::size_t>(web)];
  group.lights.push_back(of_lamp > 0.0f ? tree_light(light, beam) : TreeLight{});
}

std::optional<LightSample> sample_point(const WhittedLight& light, float unit, Vec3f from) {
  const Vec3f to = light.at_place > 0.0f ? light.position - from : light.toward;
  const float length = glm::length(to), distance = light.at_place > 0.0f ? length : kInfinity;
  if (!(length > 0.0f)) return std::nullopt;
  const Vec3f direction = to / length;
  const float s = strength(light, direction, light.at_place > 0.0f ? distance : 0.0f);
  if (!(s > 0.0f)) return std::nullopt;
  return LightSample{direction, distance, unit * s * light.color, kInfinity, true};
}

std::optional<LightSample> sample_sky(const Environment::Sample& sky) {
  if (!(sky.density > 0.0f)) return std::nullopt;
  return LightSample{sky.direction, kInfinity, sky.radiance, sky.density};
}

}  // namespace

LightTable::LightTable(const LightSources& sources, const Environment& environment)
    : sources_(sources),
      environment_(environment),
      unit_(has_phong(sources.scene) ? kPi : 1.0f),
      triangles_(sources),
      choice_(make_choice()) {}

/// The group of point lamps has an element for every lamp of the scene, so that indices match. Lamps with a size have power 0
/// in this group.
LightChoice LightTable::make_choice() {
  LightGroup points, rounds;
  points.most_by_power = rounds.most_by_power = kMostLampsByPower;
  for (std::size_t l = 0; l < sources_.lights.size(); ++l) {
    const WhittedLight& light = sources_.lights[l];
    const bool has_size = is_round(light, sources_.size);
    add_lamp(sources_, l, has_size ? 0.0f : power(light, unit_), points);
    if (!has_size) continue;
    add_lamp(sources_, l, power(light, unit_), rounds);
    if (!(light.at_place > 0.0f)) suns_.push_back(static_cast<std::uint32_t>(rounds_.size()));
    rounds_.push_back(l);
  }
  for (LightGroup* group : {&points, &rounds}) group->irradiance = unit_ * sum_of_powers(group->lights);
  const float of_sky = 4.0f * kPi * luminance(environment_.mean_radiance()), of_sun = environment_.sun_share();
  return LightChoice({std::move(points), std::move(rounds), triangles_.group()}, finite_power(of_sky * of_sun),
                     finite_power(of_sky * (1.0f - of_sun)));
}

std::optional<LightSample> LightTable::sample_light(const LightChoice::Chosen& chosen, Vec3f from, Vec2f u) const {
  switch (chosen.part) {
    case LightChoice::kPoints:
      return sample_point(sources_.lights[chosen.light], unit_, from);
    case LightChoice::kRounds:
      return sample_round(sources_.lights[rounds_[chosen.light]], unit_, from, u);
    case LightChoice::kTriangles:
      return triangles_.sample(chosen.light, from, u);
    case LightChoice::kSun:
      return sample_sky(environment_.sample_sun(u));
    case LightChoice::kSky:
      break;
  }
  return sample_sky(environment_.sample_rest(u));
}

std::optional<LightSample> LightTable::sample(const LightReceiver& at, float pick, Vec2f u) const {
  const std::optional<LightChoice::Chosen> chosen = choice_.choose(at, pick);
  if (!chosen) return std::nullopt;
  std::optional<LightSample> s = sample_light(*chosen, at.position, u);
  if (!s) return std::nullopt;
  if (s->is_point()) s->radiance /= chosen->chance;
  s->density *= chosen->chance;
  return s;
}

std::optional<LightSample> LightTable::see_round(std::size_t k, Vec3f from, Vec3f direction) const {
  return lippmann::see_round(sources_.lights[rounds_[k]], unit_, from, direction);
}

bool LightTable::is_pointed_at(std::size_t k, const RayPacket& rays) const {
  return lippmann::is_pointed_at(sources_.lights[rounds_[k]], rays);
}

float LightTable::density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const {
  const Environment::Density density = environment_.density(rays, i);
  return (density.of_sun ? choice_.chance_of_sun(at) : choice_.chance_of_sky(at)) * density.value;
}

float LightTable::density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction,
                             const LightReceiver& at) const {
  const std::optional<std::size_t> triangle = triangles_.find(record, prim);
  const float area = triangle ? triangles_.seen_area(*triangle, direction) : 0.0f;
  if (!(area > 0.0f)) return 0.0f;
  return choice_.chance_of(LightChoice::kTriangles, *triangle, at) * distance * distance / area;
}

}  // namespace lippmann
