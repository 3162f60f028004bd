#include "shading/light_table.hpp"

#include <algorithm>
#include <utility>

#include "shading/look_up.hpp"
#include "shading/round_lights.hpp"
#include "shading/shaded_scene.hpp"
#include "transport/bsdf.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

constexpr float kBelowOne = 1.0f - 0x1p-24f;

bool has_phong(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return std::holds_alternative<PhongSurface>(m.surface); });
}

/// The light's share that reaches a point at `distance` in `direction` (to the light); its fading with both.
float strength(const WhittedLight& light, Vec3f direction, float distance) {
  if (distance > light.range) return 0.0f;
  float s = light.falls_off > 0.0f ? 1.0f / std::max(distance * distance, 1e-20f) : 1.0f;
  s *= fading(light, direction);
  if (light.attenuates) s /= light.attenuation.x + distance * (light.attenuation.y + distance * light.attenuation.z);
  return s;
}

/// What a light sends into the scene, so that all kinds can be compared: irradiance is taken as falling on its cross-section.
float power(const WhittedLight& light, float unit, float size) {
  const float color = unit * luminance(light.color);
  return light.falls_off > 0.0f ? 4.0f * kPi * color : kPi * size * size * color;
}

}  // namespace

LightTable::LightTable(const LightSources& sources, const Environment& environment)
    : sources_(sources),
      environment_(environment),
      unit_(has_phong(sources.scene) ? kPi : 1.0f),
      first_triangle_(sources.records.size(), -1) {
  std::vector<float> powers;
  for (const WhittedLight& light : sources_.lights) powers.push_back(power(light, unit_, sources_.size));
  find_rounds();
  for (const std::size_t light : rounds_) powers.push_back(std::exchange(powers[light], 0.0f));
  const float of_sky = 4.0f * kPi * kPi * sources_.size * sources_.size * luminance(environment_.mean_radiance());
  powers.push_back(of_sky * environment_.sun_share());
  add_triangles(powers);
  powers.push_back(of_sky * (1.0f - environment_.sun_share()));
  for (float& p : powers)
    if (!std::isfinite(p)) p = 0.0f;
  chances_ = DiscreteDistribution(powers);
  if (chances_.empty()) return;
  begins_ = {0.0f,
             chances_.probability_before(points()),
             chances_.probability_before(sun()),
             chances_.probability_before(first_triangle()),
             chances_.probability_before(powers.size() - 1),
             1.0f};
}

void LightTable::find_rounds() {
  for (std::size_t l = 0; l < points(); ++l) {
    if (!is_round(sources_.lights[l], sources_.size)) continue;
    round_of_.resize(points(), -1);
    round_of_[l] = static_cast<int>(rounds_.size());
    rounds_.push_back(l);
  }
}

void LightTable::add_triangles(std::vector<float>& powers) {
  for (std::size_t r = 0; r < sources_.records.size(); ++r) {
    const GeometryRecord& record = sources_.records[r];
    if (record.kind != GeometryKind::kMesh || record.hidden) continue;
    const Instance& instance = sources_.scene.instances[record.instance];
    const WhittedMaterial& material = sources_.materials[static_cast<std::size_t>(instance.material)];
    if (material.emission == Vec3f(0.0f)) continue;
    float radiance = luminance(material.emission);
    if (material.emission_map.texture >= 0) {
      const DeviceTexture::Level& mean =
          sources_.textures[static_cast<std::size_t>(material.emission_map.texture)].levels.back();
      // Not 0 for a texture that is nearly dark: its bright texels must have a chance.
      radiance *= std::max(luminance(Vec3f(mean.rgba[0], mean.rgba[1], mean.rgba[2]) / 65535.0f), 1e-3f);
    }
    first_triangle_[r] = static_cast<int>(triangles_.size());
    const Affine3f place = record.placed ? record.world_from_mesh : Affine3f{};
    for (std::uint32_t t = 0; t < record.mesh->triangles.size(); ++t) {
      const auto& [a, b, c] = record.mesh->triangles[t];
      const Vec3f origin = transform_point(place, record.mesh->positions[a]);
      const Vec3f edge_b = transform_point(place, record.mesh->positions[b]) - origin;
      const Vec3f edge_c = transform_point(place, record.mesh->positions[c]) - origin;
      const Vec3f n = glm::cross(edge_b, edge_c);
      const float twice_area = glm::length(n);
      const bool has_area = twice_area > 0.0f && std::isfinite(twice_area);
      triangles_.push_back({origin, edge_b, edge_c, has_area ? n / twice_area : Vec3f(0.0f), 0.5f * twice_area,
                            static_cast<std::uint32_t>(r), t});
      powers.push_back(has_area ? kPi * 2.0f * triangles_.back().area * radiance : 0.0f);  // shines on both sides
    }
  }
}

std::optional<LightSample> LightTable::sample(Vec3f from, float pick, Vec2f u) const {
  if (chances_.empty()) return std::nullopt;
  float rest = 0.0f;
  const std::size_t chosen = chances_.sample(pick, rest);
  const float chance = chances_.probability(chosen);
  std::optional<LightSample> s;
  if (chosen < points())
    s = sample_point(chosen, from);
  else if (chosen < sun())
    s = round(chosen - points(), from, u);
  else if (chosen == sun())
    s = sample_sky(environment_.sample_sun(u));
  else if (chosen < first_triangle() + triangles_.size())
    s = sample_triangle_light(triangles_[chosen - first_triangle()], from, u);
  else
    s = sample_sky(environment_.sample_rest(u));
  if (!s) return std::nullopt;
  if (s->is_point()) s->radiance /= chance;
  s->density *= chance;
  return s;
}

std::optional<LightSample> LightTable::sample(LightGroups groups, Vec3f from, float pick, Vec2f u) const {
  const float share = chance(groups), begin = begin_of(groups.begin);
  if (!(share > 0.0f)) return std::nullopt;
  std::optional<LightSample> s = sample(from, std::clamp(begin + share * pick, begin, begin_of(groups.end) * kBelowOne), u);
  if (!s) return std::nullopt;
  s->density /= share;
  if (s->is_point()) s->radiance *= share;
  return s;
}

std::optional<LightSample> LightTable::round(std::size_t k, Vec3f from, Vec2f u) const {
  return sample_round(sources_.lights[rounds_[k]], unit_, from, u);
}

std::optional<LightSample> LightTable::see_round(std::size_t k, Vec3f from, Vec3f direction) const {
  return lippmann::see_round(sources_.lights[rounds_[k]], unit_, from, direction);
}

bool LightTable::is_pointed_at(std::size_t k, const RayPacket& rays) const {
  return lippmann::is_pointed_at(sources_.lights[rounds_[k]], rays);
}

float LightTable::chance_of_lamp(std::size_t light) const {
  if (chances_.empty()) return 0.0f;
  return has_size(light) ? chance_of_round(static_cast<std::size_t>(round_of_[light])) : chances_.probability(light);
}

std::optional<LightSample> LightTable::sample_point(std::size_t index, Vec3f from) const {
  if (has_size(index)) return std::nullopt;
  const WhittedLight& light = sources_.lights[index];
  const Vec3f to = light.at_place > 0.0f ? light.position - from : light.toward;
  const float length = glm::length(to), distance = light.at_place > 0.0f ? length : kInfinity;
  if (!(length > 0.0f)) return std::nullopt;
  const Vec3f direction = to / length;
  const float s = strength(light, direction, light.at_place > 0.0f ? distance : 0.0f);
  if (!(s > 0.0f)) return std::nullopt;
  return LightSample{direction, distance, unit_ * s * light.color, kInfinity, true};
}

std::optional<LightSample> LightTable::sample_sky(const Environment::Sample& sky) const {
  if (!(sky.density > 0.0f)) return std::nullopt;
  return LightSample{sky.direction, kInfinity, environment_.radiance(sky.direction), sky.density};
}

std::optional<LightSample> LightTable::sample_triangle_light(const Triangle& t, Vec3f from, Vec2f u) const {
  const Vec2f at = sample_triangle(u);
  const Vec3f to = t.origin + at.x * t.edge_b + at.y * t.edge_c - from;
  const float squared = glm::dot(to, to);
  if (!(squared > 0.0f)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3f direction = to / distance;
  const float cosine = std::abs(glm::dot(direction, t.normal));
  if (!(cosine > 0.0f)) return std::nullopt;
  return LightSample{direction, distance, emission_at(t, at), squared / (cosine * t.area)};
}

Vec3f LightTable::emission_at(const Triangle& t, Vec2f barycentric) const {
  const GeometryRecord& record = sources_.records[t.record];
  const auto material = static_cast<std::size_t>(sources_.scene.instances[record.instance].material);
  const Vec3f factor = sources_.materials[material].emission;
  const auto* surface = std::get_if<MetallicRoughness>(&sources_.scene.materials[material].surface);
  if (!surface) return factor;
  return factor * Vec3f(look_up(surface->emissive_map, sources_.textures, *record.mesh, t.prim, barycentric));
}

float LightTable::chance_of_record(std::size_t record) const {
  if (first_triangle_[record] < 0 || chances_.empty()) return 0.0f;
  const std::size_t first = first_triangle() + static_cast<std::size_t>(first_triangle_[record]);
  return chances_.probability_before(first + sources_.records[record].mesh->triangles.size()) -
         chances_.probability_before(first);
}

LightTable::Sky LightTable::sky(Vec3f direction) const {
  const Environment::Density density = environment_.density(direction);
  const LightGroups group = density.of_sun ? kSun : kSkyLight;
  return {group, chance(group) * density.value};
}

float LightTable::density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction) const {
  if (first_triangle_[record] < 0 || chances_.empty()) return 0.0f;
  const std::size_t index = static_cast<std::size_t>(first_triangle_[record]) + prim;
  const Triangle& t = triangles_[index];
  const float cosine = std::abs(glm::dot(direction, t.normal));
  if (!(cosine > 0.0f)) return 0.0f;
  return chances_.probability(first_triangle() + index) * distance * distance / (cosine * t.area);
}

}  // namespace lippmann
