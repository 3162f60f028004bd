#include "shading/shining_triangles.hpp"

#include "shading/look_up.hpp"
#include "shading/shaded_scene.hpp"
#include "shading/tree_lights.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

/// Scenes with more emissive triangles than this sample them by a tree instead of by power.
constexpr std::size_t kMostTrianglesByPower = 4;

/// Returns the facing of a closed mesh after a transform. A mirroring transform reverses the facing.
BodyFacing mirrored(BodyFacing facing, const Affine3f& place) {
  if (facing == BodyFacing::kNone || glm::determinant(place.linear) > 0.0f) return facing;
  return facing == BodyFacing::kOutward ? BodyFacing::kInward : BodyFacing::kOutward;
}

bool is_opaque(const WhittedMaterial& m) { return !m.has_alpha && !(m.wall_ior > 0.0f) && !(shadow_transmittance(m) > 0.0f); }

constexpr Bounds3f kEndless{Vec3f(-kInfinity), Vec3f(kInfinity)};

/// Returns slightly enlarged bounds of the transformed mesh, so that points on the mesh itself do not count as outside.
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

}  // namespace

ShiningTriangles::ShiningTriangles(const LightSources& sources) : sources_(sources), first_(sources.records.size(), -1) {
  for (std::size_t r = 0; r < sources_.records.size(); ++r) add(r);
}

void ShiningTriangles::add(std::size_t r) {
  const GeometryRecord& record = sources_.records[r];
  if (record.kind != GeometryKind::kMesh || record.hidden) return;
  const Emitter* emitter = sources_.emitters.of(record.instance);
  if (!emitter) return;
  first_[r] = static_cast<int>(triangles_.size());
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
  }
  const auto material = static_cast<std::size_t>(sources_.scene.instances[record.instance].material);
  if (closed != BodyFacing::kNone && is_opaque(sources_.materials[material])) bodies_[r] = bounds_of(*record.mesh, place);
}

/// A two-sided triangle with flux F has the intensity F cos(t) / (2 pi) at the angle t to its normal. A point on the normal at
/// distance 1 thus receives the irradiance F / (2 pi).
LightGroup ShiningTriangles::group() const {
  LightGroup group{{}, std::vector<float>(triangles_.size(), 0.0f), {}, 0.0f, kMostTrianglesByPower};
  for (const Triangle& t : triangles_) {
    const bool has_area = t.normal != Vec3f(0.0f);
    const Emitter& emitter = *sources_.emitters.of(sources_.records[t.record].instance);
    // Factor 2: both sides emit
    const float power = has_area ? finite_power(kPi * 2.0f * t.area * emitter.of(t.prim)) : 0.0f;
    group.near.push_back(power);
    group.lights.push_back(power > 0.0f ? tree_light(t.origin, t.edge_b, t.edge_c, power, t.closed) : TreeLight{});
  }
  group.irradiance = sum_of_powers(group.lights) / (2.0f * kPi);
  return group;
}

std::optional<std::size_t> ShiningTriangles::find(std::uint32_t record, std::uint32_t prim) const {
  if (first_[record] < 0) return std::nullopt;
  return static_cast<std::size_t>(first_[record]) + prim;
}

float ShiningTriangles::seen_area(std::size_t triangle, Vec3f direction) const {
  const Triangle& t = triangles_[triangle];
  return std::abs(glm::dot(direction, t.normal)) * t.area;
}

/// This test needs no shadow ray. Shadow rays end just before the light, so near an edge they may miss the part of the mesh
/// that hides the light.
bool ShiningTriangles::is_hidden(const Triangle& t, Vec3f from, Vec3f direction) const {
  if (t.closed == BodyFacing::kNone || !is_outside(bodies_[t.record], from)) return false;
  return (glm::dot(direction, t.normal) > 0.0f) == (t.closed == BodyFacing::kOutward);
}

std::optional<LightSample> ShiningTriangles::sample(std::size_t triangle, Vec3f from, Vec2f u) const {
  const Triangle& t = triangles_[triangle];
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

Vec3f ShiningTriangles::emission_at(const Triangle& t, Vec2f barycentric) const {
  const GeometryRecord& record = sources_.records[t.record];
  const auto material = static_cast<std::size_t>(sources_.scene.instances[record.instance].material);
  const Vec3f factor = sources_.materials[material].emission;
  const auto* surface = std::get_if<MetallicRoughness>(&sources_.scene.materials[material].surface);
  if (!surface) return factor;
  return factor * Vec3f(look_up(surface->emissive_map, sources_.textures, *record.mesh, t.prim, barycentric));
}

}  // namespace lippmann
