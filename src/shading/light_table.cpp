#include "shading/light_table.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "shading/look_up.hpp"
#include "shading/round_lights.hpp"
#include "shading/shaded_scene.hpp"
#include "shading/tree_lights.hpp"
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

/// Powers too large for floats are the largest; what is no number has none.
float finite(float power) { return power > 0.0f ? std::min(power, std::numeric_limits<float>::max()) : 0.0f; }

/// Far lights send the same irradiance to all points of the scene.
bool is_near(const WhittedLight& light) { return light.falls_off > 0.0f; }

/// The flux of a near light; the irradiance of a far one across its direction.
float power(const WhittedLight& light, float unit) {
  const float color = unit * luminance(light.color);
  return finite(is_near(light) ? 4.0f * kPi * color : color);
}

/// Which way the triangles of a closed mesh face once it is placed: a mirror turns them.
BodyFacing mirrored(BodyFacing facing, const Affine3f& place) {
  if (facing == BodyFacing::kNone || glm::determinant(place.linear) > 0.0f) return facing;
  return facing == BodyFacing::kOutward ? BodyFacing::kInward : BodyFacing::kOutward;
}

/// Whether all shadow rays end at it.
bool is_opaque(const WhittedMaterial& m) { return !m.has_alpha && !(m.wall_ior > 0.0f) && !(shadow_transmittance(m) > 0.0f); }

constexpr Bounds3f kEndless{Vec3f(-kInfinity), Vec3f(kInfinity)};

/// A little wider than the mesh: points on its own surface, which may be the walls of a room that shines, are not outside.
Bounds3f bounds_of(const Mesh& mesh, const Affine3f& place) {
  constexpr float kMargin = 1e-3f, kRounding = 1e-5f;
  Bounds3f bounds;
  for (const Vec3f& p : mesh.positions) bounds.add(transform_point(place, p));
  const Vec3f margin = kMargin * bounds.size() + kRounding * glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
  return {bounds.lower - margin, bounds.upper + margin};
}

bool is_outside(const Bounds3f& box, Vec3f p) {
  return glm::any(glm::lessThan(p, box.lower)) || glm::any(glm::greaterThan(p, box.upper));
}

/// A tree of the lights that have power. Where there are more than `most_by_power`, it has an entry with their power, from
/// `powers` on from `first`; else an entry without.
LightTree tree_of(std::span<const TreeLight> lights, std::size_t most_by_power, std::vector<float>& powers, std::size_t first) {
  const auto in_tree = std::count_if(lights.begin(), lights.end(), [](const TreeLight& l) { return l.power > 0.0f; });
  powers.push_back(0.0f);
  if (static_cast<std::size_t>(in_tree) > most_by_power) {
    double sum = 0.0;
    for (std::size_t l = 0; l < lights.size(); ++l)
      if (lights[l].power > 0.0f) sum += static_cast<double>(std::exchange(powers[first + l], 0.0f));
    powers.back() = static_cast<float>(sum);
  }
  return LightTree(lights);
}

float sum_of_powers(std::span<const TreeLight> lights) {
  double sum = 0.0;
  for (const TreeLight& l : lights) sum += static_cast<double>(l.power);
  return static_cast<float>(sum);
}

}  // namespace

LightTable::LightTable(const LightSources& sources, const Environment& environment)
    : sources_(sources),
      environment_(environment),
      unit_(has_phong(sources.scene) ? kPi : 1.0f),
      first_triangle_(sources.records.size(), -1) {
  find_rounds();
  Powers powers;
  add_points(powers);
  add_rounds(powers);
  const float of_sky = 4.0f * kPi * luminance(environment_.mean_radiance());
  powers.push_back(0.0f, finite(of_sky * environment_.sun_share()));
  add_triangles(powers);
  powers.push_back(0.0f, finite(of_sky * (1.0f - environment_.sun_share())));
  near_ = kind_of(powers.near), far_ = kind_of(powers.far);
  // A quarter of the flux across any direction arrives at a surface, on average over the ways that it may be turned.
  far_irradiance_ = 0.25f * static_cast<float>(far_.chances.total());
}

LightTable::Kind LightTable::kind_of(std::span<const float> powers) const {
  Kind kind{DiscreteDistribution(powers)};
  if (kind.empty()) return kind;
  kind.of_sun = kind.chances.probability_before(first_triangle()) - kind.chances.probability_before(sun());
  kind.of_sky = 1.0f - kind.chances.probability_before(powers.size() - 1);
  return kind;
}

void LightTable::find_rounds() {
  for (std::size_t l = 0; l < points(); ++l) {
    if (!is_round(sources_.lights[l], sources_.size)) continue;
    round_of_.resize(points(), -1);
    round_of_[l] = static_cast<int>(rounds_.size());
    if (!(sources_.lights[l].at_place > 0.0f)) suns_.push_back(static_cast<std::uint32_t>(rounds_.size()));
    rounds_.push_back(l);
  }
}

const WebBeam* LightTable::beam_of(std::size_t light) const {
  const int web = sources_.scene.lights[light].web;
  return web < 0 ? nullptr : &sources_.beams[static_cast<std::size_t>(web)];
}

void LightTable::add_points(Powers& powers) {
  std::vector<TreeLight> lights(points());
  for (std::size_t l = 0; l < points(); ++l) {
    const WhittedLight& light = sources_.lights[l];
    const float of_light = has_size(l) ? 0.0f : power(light, unit_);
    powers.push_back(is_near(light) ? of_light : 0.0f, is_near(light) ? 0.0f : of_light);
    if (of_light > 0.0f) lights[l] = tree_light(light, beam_of(l));
  }
  powers.far.push_back(0.0f);
  point_tree_ = tree_of(lights, kMostLampsByPower, powers.near, 0);
  tree_irradiances_[0] = unit_ * sum_of_powers(lights);
}

void LightTable::add_rounds(Powers& powers) {
  const std::size_t first = powers.near.size();
  std::vector<TreeLight> lights(rounds());
  for (std::size_t k = 0; k < rounds(); ++k) {
    const WhittedLight& light = sources_.lights[rounds_[k]];
    const float of_light = power(light, unit_);
    powers.push_back(is_near(light) ? of_light : 0.0f, is_near(light) ? 0.0f : of_light);
    if (of_light > 0.0f) lights[k] = tree_light(light, beam_of(rounds_[k]));
  }
  powers.far.push_back(0.0f);
  round_tree_ = tree_of(lights, kMostLampsByPower, powers.near, first);
  tree_irradiances_[1] = unit_ * sum_of_powers(lights);
}

/// A triangle with two sides sends flux / (2 pi) x cosine.
void LightTable::add_triangles(Powers& powers) {
  const std::size_t first = powers.near.size();
  for (std::size_t r = 0; r < sources_.records.size(); ++r) add_triangles_of(r, powers);
  std::vector<TreeLight> lights(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (const float of_triangle = powers.near[first + t]; of_triangle > 0.0f)
      lights[t] =
          tree_light(triangles_[t].origin, triangles_[t].edge_b, triangles_[t].edge_c, of_triangle, triangles_[t].closed);
  powers.far.resize(powers.near.size() + 1, 0.0f);
  triangle_tree_ = tree_of(lights, kMostTrianglesByPower, powers.near, first);
  tree_irradiances_[2] = sum_of_powers(lights) / (2.0f * kPi);
}

void LightTable::add_triangles_of(std::size_t r, Powers& powers) {
  const GeometryRecord& record = sources_.records[r];
  if (record.kind != GeometryKind::kMesh || record.hidden) return;
  const Emitter* emitter = sources_.emitters.of(record.instance);
  if (!emitter) return;
  first_triangle_[r] = static_cast<int>(triangles_.size());
  bodies_.resize(sources_.records.size(), kEndless);
  const Affine3f place = record.placed ? record.world_from_mesh : Affine3f{};
  const BodyFacing closed = mirrored(emitter->closed, place);
  for (std::uint32_t t = 0; t < record.mesh->triangles.size(); ++t) {
    const auto& [a, b, c] = record.mesh->triangles[t];
    const Vec3f origin = transform_point(place, record.mesh->positions[a]);
    const Vec3f edge_b = transform_point(place, record.mesh->positions[b]) - origin;
    const Vec3f edge_c = transform_point(place, record.mesh->positions[c]) - origin;
    const Vec3f n = glm::cross(edge_b, edge_c);
    const float twice_area = glm::length(n);
    const bool has_area = twice_area > 0.0f && std::isfinite(twice_area);
    triangles_.push_back({origin, edge_b, edge_c, has_area ? n / twice_area : Vec3f(0.0f), 0.5f * twice_area,
                          static_cast<std::uint32_t>(r), t, closed});
    // Both sides shine.
    powers.near.push_back(has_area ? finite(kPi * 2.0f * triangles_.back().area * emitter->of(t)) : 0.0f);
  }
  const auto material = static_cast<std::size_t>(sources_.scene.instances[record.instance].material);
  if (closed != BodyFacing::kNone && is_opaque(sources_.materials[material])) bodies_[r] = bounds_of(*record.mesh, place);
}

float LightTable::near_share(const LightReceiver& at) const {
  if (near_.empty() || far_.empty()) return near_.empty() ? 0.0f : 1.0f;
  if (at.near_share >= 0.0f) return at.near_share;
  float irradiance = 0.0f;
  const std::array<TreeOfGroup, 3> groups = trees();
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (!groups[g].tree.empty()) irradiance += tree_irradiances_[g] * groups[g].tree.importance(at);
  const float share = 1.0f - 1.0f / (1.0f + irradiance / far_irradiance_);
  return std::min(1.0f - kLeastShareOfKind, std::max(kLeastShareOfKind, share));
}

float LightTable::chance_of_sky(const LightReceiver& at) const {
  const float near = near_share(at);
  return near * near_.of_sky + (1.0f - near) * far_.of_sky;
}

/// A tree draws anew, with what is left of the number that has chosen it. Trees are asked first, as the list of all entries is
/// long where there are any.
std::optional<LightTable::Chosen> LightTable::choose(const Kind& kind, const LightReceiver& at, float pick) const {
  for (const TreeOfGroup& group : trees()) {
    if (group.tree.empty()) continue;
    const float begin = kind.chances.probability_before(group.entry), end = kind.chances.probability_before(group.entry + 1);
    if (!(begin <= pick && pick < end)) continue;
    const float chance = end - begin;
    const std::optional<LightTree::Choice> choice = group.tree.choose(at, std::min((pick - begin) / chance, kBelowOne));
    if (!choice) return std::nullopt;
    return Chosen{group.first + choice->light, chance * choice->probability};
  }
  float rest = 0.0f;
  const std::size_t entry = kind.chances.sample(pick, rest);
  return Chosen{entry, kind.chances.probability(entry)};
}

std::optional<LightSample> LightTable::sample_entry(std::size_t entry, Vec3f from, Vec2f u) const {
  if (entry < points()) return sample_point(entry, from);
  if (entry < round_tree()) return sample_round(sources_.lights[rounds_[entry - first_round()]], unit_, from, u);
  if (entry == sun()) return sample_sky(environment_.sample_sun(u));
  if (entry < triangle_tree()) return sample_triangle_light(triangles_[entry - first_triangle()], from, u);
  return sample_sky(environment_.sample_rest(u));
}

/// `pick` first chooses near or far lights. Its position within the chosen range then chooses a light of that kind.
std::optional<LightSample> LightTable::sample(const LightReceiver& at, float pick, Vec2f u) const {
  if (near_.empty() && far_.empty()) return std::nullopt;
  const float near = near_share(at);
  const bool is_near = pick < near || far_.empty();
  const float of_kind = is_near ? near : 1.0f - near, within = (is_near ? pick : pick - near) / of_kind;
  const std::optional<Chosen> chosen = choose(is_near ? near_ : far_, at, std::clamp(within, 0.0f, kBelowOne));
  if (!chosen) return std::nullopt;
  std::optional<LightSample> s = sample_entry(chosen->entry, at.position, u);
  if (!s) return std::nullopt;
  const float chance = of_kind * chosen->chance;
  if (s->is_point()) s->radiance /= chance;
  s->density *= chance;
  return s;
}

float LightTable::chance_of_round(std::size_t k, const LightReceiver& at) const {
  return chance_within(round_tree_, round_tree(), first_round(), k, at);
}

/// A light has its own entry, near or far, or is drawn by the tree.
float LightTable::chance_within(const LightTree& tree, std::size_t of_tree, std::size_t first, std::size_t index,
                                const LightReceiver& at) const {
  const float near = near_share(at);
  const float own = near * near_.probability(first + index) + (1.0f - near) * far_.probability(first + index);
  if (own > 0.0f || !(near_.probability(of_tree) > 0.0f)) return own;
  return near * near_.probability(of_tree) * tree.probability(static_cast<std::uint32_t>(index), at);
}

std::optional<LightSample> LightTable::see_round(std::size_t k, Vec3f from, Vec3f direction) const {
  return lippmann::see_round(sources_.lights[rounds_[k]], unit_, from, direction);
}

bool LightTable::is_pointed_at(std::size_t k, const RayPacket& rays) const {
  return lippmann::is_pointed_at(sources_.lights[rounds_[k]], rays);
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
  return LightSample{sky.direction, kInfinity, sky.radiance, sky.density};
}

/// Shadow rays would tell, too, but for those that end near an edge: they stop short of the light by more than there is of the
/// body before it. Inner sides are asked so rarely that each such ray would be a white dot.
bool LightTable::is_hidden(const Triangle& t, Vec3f from, Vec3f direction) const {
  if (t.closed == BodyFacing::kNone || !is_outside(bodies_[t.record], from)) return false;
  return (glm::dot(direction, t.normal) > 0.0f) == (t.closed == BodyFacing::kOutward);
}

std::optional<LightSample> LightTable::sample_triangle_light(const Triangle& t, Vec3f from, Vec2f u) const {
  const Vec2f at = sample_triangle(u);
  const Vec3f to = t.origin + at.x * t.edge_b + at.y * t.edge_c - from;
  const float squared = glm::dot(to, to);
  if (!(squared > 0.0f)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3f direction = to / distance;
  const float cosine = std::abs(glm::dot(direction, t.normal));
  if (!(cosine > 0.0f) || is_hidden(t, from, direction)) return std::nullopt;
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

float LightTable::density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const {
  const Environment::Density density = environment_.density(rays, i);
  const float near = near_share(at);
  const float chance = density.of_sun ? near * near_.of_sun + (1.0f - near) * far_.of_sun : chance_of_sky(at);
  return chance * density.value;
}

float LightTable::density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction,
                             const LightReceiver& at) const {
  if (first_triangle_[record] < 0 || near_.empty()) return 0.0f;
  const std::size_t index = static_cast<std::size_t>(first_triangle_[record]) + prim;
  const Triangle& t = triangles_[index];
  const float cosine = std::abs(glm::dot(direction, t.normal));
  if (!(cosine > 0.0f)) return 0.0f;
  return chance_within(triangle_tree_, triangle_tree(), first_triangle(), index, at) * distance * distance / (cosine * t.area);
}

}  // namespace lippmann
