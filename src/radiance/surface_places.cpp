#include "radiance/surface_places.hpp"

#include <cmath>
#include <numeric>

#include "core/random.hpp"

namespace lippmann {
namespace {

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// Around edges of boxes light changes abruptly, and with it the side, of which each is a thing of its own: that of the axis
/// which the normal is nearest to. What is smooth is not to be cut there: sides overlap, so that cells on both sides of their
/// border, as large ones as fit into the overlap, hold the same light.
constexpr std::uint32_t kSides = 6;
/// A normal whose component along an axis is so much of that along the nearest one is near the side of that axis, too: within
/// 14 degrees of the border between the two.
constexpr float kNearSide = 0.6f;

int nearest_axis(Vec3f n) {
  const Vec3f a = glm::abs(n);
  return a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
}

std::uint32_t side_of(Vec3f n, int axis) { return static_cast<std::uint32_t>(2 * axis + (n[axis] < 0.0f)); }

}  // namespace

std::vector<std::uint32_t> connected_parts(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const auto& [a, b, c] : mesh.triangles)
    for (const std::uint32_t v : {b, c}) {
      const std::uint32_t x = root_of(parent, a), y = root_of(parent, v);
      parent[std::max(x, y)] = std::min(x, y);
    }
  std::vector<std::uint32_t> parts;
  parts.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) parts.push_back(root_of(parent, triangle[0]));
  return parts;
}

SurfacePlaces::SurfacePlaces(const ShadedScene& scene)
    : scene_(scene),
      spaces_(scene.scene->instances.size()),
      parts_of_record_(scene.records.size(), nullptr),
      rest_of_record_(scene.records.size(), nullptr) {
  for (std::uint32_t i = 0; i < spaces_.size(); ++i) {
    spaces_[i].moves = scene.instance_moves[i];
    if (!spaces_[i].moves) continue;
    for (std::uint32_t side = 0; side < kSides; ++side) instance_of_.emplace(hash(i, side), i);
  }
  for (const std::unique_ptr<PosedMesh>& posed : scene.posed) {
    const Instance& instance = scene.scene->instances[scene.records[posed->record].instance];
    rest_of_record_[posed->record] = &std::get<Mesh>(scene.scene->shapes[static_cast<std::size_t>(instance.shape)]);
  }
  for (std::size_t r = 0; r < scene.records.size(); ++r) {
    if (scene.records[r].kind != GeometryKind::kMesh) continue;
    const Mesh* mesh = scene.records[r].mesh;
    const auto [entry, is_new] = parts_.try_emplace(mesh);
    if (is_new) entry->second = connected_parts(*mesh);
    parts_of_record_[r] = &entry->second;
  }
}

void SurfacePlaces::update(const ResolvedScene& resolved) {
  for (std::size_t i = 0; i < spaces_.size(); ++i) {
    Space& space = spaces_[i];
    if (!space.moves) continue;
    const Affine3f world_from_own = resolved.of(scene_.scene->instances[i].node);
    const float scale = uniform_scale(world_from_own);
    if (!(scale > 0.0f) || !std::isfinite(scale)) continue;  // nothing of it is seen
    space.world_from_own_before = space.world_from_own;
    space.world_from_own = world_from_own;
    space.world_from_own.linear /= scale;
    if (!space.was_seen) space.world_from_own_before = space.world_from_own;
    space.was_seen = true;
    space.own_from_world = inverse(world_from_own);
    space.own_from_world.linear *= scale;
    space.own_from_world.translation *= scale;
    space.own_from_world_normal = glm::transpose(world_from_own.linear);
  }
  update_lights();
}

void SurfacePlaces::update_lights() {
  near_lights_moved_ = far_lights_moved_ = 0.0f;
  const LightTable& table = *scene_.path->lights;
  lights_.resize(scene_.lights.size(), Vec3f(std::nanf("")));
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const float moved = glm::length(scene_.lights[l].position - lights_[l]);
    const WhittedLight& light = scene_.lights[l];
    if (light.at_place > 0.0f && std::isfinite(moved))
      (light.falls_off > 0.0f ? near_lights_moved_ : far_lights_moved_) += table.share_of_lamp(l) * moved;
    lights_[l] = scene_.lights[l].position;
  }
  for (std::size_t r = 0; r < scene_.records.size(); ++r) {
    const float chance = table.share_of_record(r);
    if (!(chance > 0.0f)) continue;
    const Space& space = spaces_[scene_.records[r].instance];
    if (space.moves)
      near_lights_moved_ += chance * glm::length(space.world_from_own.translation - space.world_from_own_before.translation);
  }
}

float SurfacePlaces::moved(std::uint32_t thing, Vec3f position) const {
  float by_lights = 0.0f;
  if (near_lights_moved_ > 0.0f || far_lights_moved_ > 0.0f)
    by_lights = glm::mix(far_lights_moved_, near_lights_moved_, scene_.path->lights->near_share({position}));
  const auto found = instance_of_.find(thing);
  if (found == instance_of_.end()) return by_lights;
  const Space& space = spaces_[found->second];
  return by_lights +
         glm::length(transform_point(space.world_from_own, position) - transform_point(space.world_from_own_before, position));
}

/// Whether the surface goes on smoothly at the edges of what was hit.
bool SurfacePlaces::is_smooth(std::uint32_t record, std::uint32_t prim) const {
  if (record >= kPlaneId) return false;
  if (scene_.records[record].kind != GeometryKind::kMesh) return true;
  const Mesh& mesh = *scene_.records[record].mesh;
  if (mesh.normals.empty()) return false;
  const auto& [a, b, c] = mesh.triangles[prim];
  return mesh.normals[a] != mesh.normals[b] || mesh.normals[a] != mesh.normals[c];
}

CachePoint SurfacePlaces::operator()(const RayHitPacket& packet, const SurfacePacket& surface, int i, Vec3f& normal,
                                     float size) const {
  const std::uint32_t instance = surface.instance[i], record = surface.record[i], prim = packet.hit.primID[i];
  const Space& space = spaces_[instance];
  CachePoint place;
  place.size = size;
  place.position = surface.position.get(i);
  const Mesh* rest = record < kPlaneId ? rest_of_record_[record] : nullptr;
  if (rest && space.moves) {
    const auto& [a, b, c] = rest->triangles[prim];
    const bool mirrored = scene_.records[record].mesh->triangles[prim][1] != b;
    const float u = mirrored ? packet.hit.v[i] : packet.hit.u[i], v = mirrored ? packet.hit.u[i] : packet.hit.v[i];
    const Vec3f edge_b = rest->positions[b] - rest->positions[a], edge_c = rest->positions[c] - rest->positions[a];
    const float outer = (surface.entering.lane[i] != 0) != mirrored ? 1.0f : -1.0f;
    const Vec3f across = glm::cross(edge_b, edge_c);
    if (across != Vec3f(0.0f)) normal = outer * glm::normalize(across);
    // As large as it is shown: cells are in units of the world.
    const Mesh& bent = *scene_.records[record].mesh;
    const auto& corners = bent.triangles[prim];
    const float shown = glm::length(bent.positions[corners[1]] - bent.positions[corners[0]]) +
                        glm::length(bent.positions[corners[2]] - bent.positions[corners[0]]);
    const float drawn = glm::length(edge_b) + glm::length(edge_c);
    place.position = rest->positions[a] + u * edge_b + v * edge_c;
    if (shown > 0.0f && drawn > 0.0f) place.size = size * (drawn / shown);
  } else if (space.moves) {
    place.position = transform_point(space.own_from_world, place.position);
    normal = glm::normalize(space.own_from_world_normal * normal);
  }
  place.thing = hash(instance, side_of(normal, nearest_axis(normal)));
  if (record >= kPlaneId) return place;
  const std::vector<std::uint32_t>* parts = parts_of_record_[record];
  place.part = parts ? (*parts)[prim] : prim;
  return place;
}

std::array<std::uint32_t, 2> SurfacePlaces::sides_near(const RayHitPacket& packet, const SurfacePacket& surface, int i,
                                                       Vec3f normal) const {
  std::array<std::uint32_t, 2> sides{};
  if (!is_smooth(surface.record[i], packet.hit.primID[i])) return sides;
  const int nearest = nearest_axis(normal);
  std::size_t found = 0;
  for (const int axis : {(nearest + 1) % 3, (nearest + 2) % 3})
    if (std::abs(normal[axis]) > kNearSide * std::abs(normal[nearest]))
      sides[found++] = hash(surface.instance[i], side_of(normal, axis));
  return sides;
}

}  // namespace lippmann
