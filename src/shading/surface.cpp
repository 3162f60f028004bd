#include "shading/surface.hpp"

#include <limits>

#include "shading/smooth_lift.hpp"
#include "shading/surface_material.hpp"

namespace lippmann {
namespace {

LIPPMANN_MULTIVERSION void place_hits(const RayHitPacket& packet, const LaneMask& active, float least_t_near,
                                      SurfacePacket& s) {
  // Rounding errors of a point are about 10^-7 of its coordinates and of the ray's length. kRounding leaves a margin of 100.
  constexpr float kRounding = 1e-5f;
  int any = 0, all = -1;
  LIPPMANN_FOR_LANES(i) {
    const int hit = ((active.lane[i] != 0) & (packet.hit.geomID[i] < kLightId)) ? -1 : 0;
    s.hit.lane[i] = hit;
    const unsigned placed = packet.hit.instID[0][i];
    s.record[i] = placed != kNoId ? placed : packet.hit.geomID[i];
    any |= hit;
    all &= hit | ~active.lane[i];
    const float t = packet.ray.tfar[i];
    s.position.x[i] = packet.ray.org_x[i] + t * packet.ray.dir_x[i];
    s.position.y[i] = packet.ray.org_y[i] + t * packet.ray.dir_y[i];
    s.position.z[i] = packet.ray.org_z[i] + t * packet.ray.dir_z[i];
    const float farthest = std::max(std::max(std::abs(s.position.x[i]), std::abs(s.position.y[i])), std::abs(s.position.z[i]));
    s.t_near[i] = std::max(least_t_near, kRounding * std::max(farthest, t));
  }
  s.any_hit = any != 0;
  s.any_miss = all == 0;
}

/// Moves all lanes with the same key as the first lane of `left` to `group`. Returns that lane, or -1 if `left` is empty.
LIPPMANN_MULTIVERSION int take_group(const std::uint32_t* key, LaneMask& left, LaneMask& group) {
  int first = kLanes;
  LIPPMANN_FOR_LANES(i) {
    const int candidate = left.lane[i] != 0 ? i : kLanes;
    first = candidate < first ? candidate : first;
  }
  if (first == kLanes) return -1;
  const std::uint32_t of_group = key[first];
  LIPPMANN_FOR_LANES(i) {
    group.lane[i] = key[i] == of_group ? left.lane[i] : 0;
    left.lane[i] = key[i] == of_group ? 0 : left.lane[i];
  }
  return first;
}

/// The smallest float that is not denormal. Facet normals are as long as twice the triangle's area, so their squares may be
/// tiny.
constexpr float kLeastSquare = std::numeric_limits<float>::min();

LIPPMANN_INLINE void face_ray(const RayPacket& rays, const LaneMask& lanes, int i, Vec3f facet, Vec3f n, SurfacePacket& s) {
  const bool behind = facet.x * rays.dir_x[i] + facet.y * rays.dir_y[i] + facet.z * rays.dir_z[i] > 0.0f;
  const float side = behind ? -1.0f : 1.0f;
  const float scale = side / std::sqrt(std::max(n.x * n.x + n.y * n.y + n.z * n.z, kLeastSquare));
  const bool wanted = lanes.lane[i] != 0;
  const int entering = behind ? 0 : -1;
  s.entering.lane[i] = wanted ? entering : s.entering.lane[i];
  s.normal.x[i] = wanted ? n.x * scale : s.normal.x[i];
  s.normal.y[i] = wanted ? n.y * scale : s.normal.y[i];
  s.normal.z[i] = wanted ? n.z * scale : s.normal.z[i];
  s.facet.x[i] = wanted ? facet.x * side : s.facet.x[i];
  s.facet.y[i] = wanted ? facet.y * side : s.facet.y[i];
  s.facet.z[i] = wanted ? facet.z * side : s.facet.z[i];
}

LIPPMANN_MULTIVERSION void set_plane(const WorldPlaneRecord& record, const RayPacket& rays, const LaneMask& lanes,
                                     SurfacePacket& s) {
  const WorldPlane plane = record.plane;
  const std::uint32_t instance = record.instance;
  LIPPMANN_FOR_LANES(i) {
    const Vec3f n(plane.nx, plane.ny, plane.nz);
    face_ray(rays, lanes, i, n, n, s);
    s.instance[i] = lanes.lane[i] != 0 ? instance : s.instance[i];
  }
}

LIPPMANN_MULTIVERSION void set_spheres(const WorldSphere* spheres, const RayHitPacket& packet, const LaneMask& lanes,
                                       SurfacePacket& s) {
  Lanes3 center;
  for (int i = 0; i < kLanes; ++i) {
    const WorldSphere& sphere = spheres[lanes.lane[i] != 0 ? packet.hit.primID[i] : 0u];
    center.x[i] = sphere.x, center.y[i] = sphere.y, center.z[i] = sphere.z;
  }
  LIPPMANN_FOR_LANES(i) {
    const Vec3f n(s.position.x[i] - center.x[i], s.position.y[i] - center.y[i], s.position.z[i] - center.z[i]);
    face_ray(packet.ray, lanes, i, n, n, s);
  }
}

LIPPMANN_MULTIVERSION void set_normals(const Lanes3& normal, const RayPacket& rays, const LaneMask& lanes, SurfacePacket& s) {
  LIPPMANN_FOR_LANES(i) {
    const Vec3f n(normal.x[i], normal.y[i], normal.z[i]);
    face_ray(rays, lanes, i, n, n, s);
  }
}

LIPPMANN_MULTIVERSION void set_mesh(const Mat3f normal_from_mesh, std::uint32_t instance, const Lanes3& smooth,
                                    const RayHitPacket& packet, const LaneMask& lanes, SurfacePacket& s) {
  const Vec3f to_x = normal_from_mesh[0], to_y = normal_from_mesh[1], to_z = normal_from_mesh[2];
  LIPPMANN_FOR_LANES(i) {
    const float fx = packet.hit.Ng_x[i], fy = packet.hit.Ng_y[i], fz = packet.hit.Ng_z[i];
    const float nx = smooth.x[i], ny = smooth.y[i], nz = smooth.z[i];
    const Vec3f facet(to_x.x * fx + to_y.x * fy + to_z.x * fz, to_x.y * fx + to_y.y * fy + to_z.y * fz,
                      to_x.z * fx + to_y.z * fy + to_z.z * fz);
    const Vec3f n(to_x.x * nx + to_y.x * ny + to_z.x * nz, to_x.y * nx + to_y.y * ny + to_z.y * nz,
                  to_x.z * nx + to_y.z * ny + to_z.z * nz);
    face_ray(packet.ray, lanes, i, facet, n, s);
    s.instance[i] = lanes.lane[i] != 0 ? instance : s.instance[i];
  }
}

void evaluate_mesh(const GeometryRecord& record, const RayHitPacket& packet, const LaneMask& lanes, SurfacePacket& s) {
  const std::vector<Vec3f>& normals = record.mesh->normals;
  Lanes3 smooth;
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    const Vec3f facet(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
    smooth.set(i, normals.empty() ? facet : at_hit(normals, record, packet, i));
  }
  set_mesh(record.normal_from_mesh, record.instance, smooth, packet, lanes, s);
}

template <class Primitive>
const PrimitiveTable<Primitive>& table(const GeometryRecord& record) {
  return *static_cast<const PrimitiveTable<Primitive>*>(record.primitives);
}

Vec3f primitive_normal(const ShadedScene& scene, const GeometryRecord& record, unsigned prim, Vec3f p) {
  if (record.kind == GeometryKind::kCylinders) return normal_at(table<WorldCylinder>(record).primitives[prim], p);
  if (record.kind == GeometryKind::kRings) return normal_at(table<WorldRing>(record).primitives[prim], p);
  const WorldBox& box = table<WorldBox>(record).primitives[prim];
  return scene.tachyon ? tachyon_box_normal(box, p) : normal_at(box, p);
}

void evaluate_primitives(const ShadedScene& scene, const GeometryRecord& record, const RayHitPacket& packet,
                         const LaneMask& lanes, SurfacePacket& s) {
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) s.instance[i] = (*record.instance_of_primitive)[packet.hit.primID[i]];
  if (record.kind == GeometryKind::kSpheres) return set_spheres(table<WorldSphere>(record).primitives.data(), packet, lanes, s);
  Lanes3 normal;
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) normal.set(i, primitive_normal(scene, record, packet.hit.primID[i], s.position.get(i)));
  set_normals(normal, packet.ray, lanes, s);
}

const GeometryRecord* evaluate_record(const ShadedScene& scene, unsigned id, const RayHitPacket& packet, const LaneMask& lanes,
                                      SurfacePacket& s) {
  if (id >= kPlaneId) {
    set_plane(scene.planes[id - kPlaneId], packet.ray, lanes, s);
    return nullptr;
  }
  const GeometryRecord& record = scene.records[id];
  if (record.kind == GeometryKind::kMesh)
    evaluate_mesh(record, packet, lanes, s);
  else
    evaluate_primitives(scene, record, packet, lanes, s);
  return &record;
}

void evaluate_materials(const ShadedScene& scene, const GeometryRecord* record, const RayHitPacket& packet,
                        const PacketBeams& beams, LaneMask lanes, SurfacePacket& s) {
  alignas(64) std::uint32_t material[kLanes];
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) material[i] = scene.material_of_instance[s.instance[i]];
  LaneMask group;
  for (int first; (first = take_group(material, lanes, group)) >= 0;)
    evaluate_material(scene, scene.materials.materials[material[first]], record, packet, beams, group, s);
}

}  // namespace

std::uint32_t hit_instance(const ShadedScene& scene, const RayHitPacket& packet, int i) {
  const unsigned id = packet.hit.instID[0][i] != kNoId ? packet.hit.instID[0][i] : packet.hit.geomID[i];
  if (id >= kPlaneId) return scene.planes[id - kPlaneId].instance;
  const GeometryRecord& record = scene.records[id];
  return record.kind == GeometryKind::kMesh ? record.instance : (*record.instance_of_primitive)[packet.hit.primID[i]];
}

Vec3f smooth_lift(const SurfacePacket& s, int i) {
  if (!s.any_smooth || s.record[i] >= kPlaneId) return Vec3f(0.0f);
  const GeometryRecord& record = s.scene->records[s.record[i]];
  if (record.kind != GeometryKind::kMesh || record.mesh->normals.empty()) return Vec3f(0.0f);
  const Mesh& mesh = *record.mesh;
  const auto& hit = s.packet->hit;
  const auto& [a, b, c] = mesh.triangles[hit.primID[i]];
  // Vertex normals may point away from the side that the winding of the triangles defines.
  const bool inverted = glm::dot(Vec3f(hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]), mesh.normals[a]) < 0.0f;
  const Vec3f lift = smooth_lift({{mesh.positions[a], mesh.positions[b], mesh.positions[c]},
                                  {mesh.normals[a], mesh.normals[b], mesh.normals[c]},
                                  {1.0f - hit.u[i] - hit.v[i], hit.u[i], hit.v[i]}},
                                 (s.entering.lane[i] != 0) != inverted ? 1.0f : -1.0f);
  return record.placed ? record.world_from_mesh.linear * lift : lift;
}

void evaluate_surfaces(const ShadedScene& scene, const RayHitPacket& packet, const LaneMask& active, const Lanes& path_length,
                       const BeamFootprint& beam, SurfacePacket& s, const LaneMask* spread) {
  const PacketBeams beams{beam, path_length, spread};
  place_hits(packet, active, scene.secondary_t_near, s);
  s.any_highlight = s.any_mirror = s.any_see_through = s.any_smooth = false;
  s.scene = &scene, s.packet = &packet;
  LaneMask left = s.hit, group;
  for (int first; s.any_hit && (first = take_group(s.record, left, group)) >= 0;) {
    const GeometryRecord* record = evaluate_record(scene, s.record[first], packet, group, s);
    // Tachyon does not lift shadow rays, and its images must be reproduced
    s.any_smooth |= record && record->kind == GeometryKind::kMesh && !record->mesh->normals.empty() && !scene.tachyon;
    const std::uint32_t material = scene.material_of_instance[s.instance[first]];
    if (!record || record->one_material)
      evaluate_material(scene, scene.materials.materials[material], record, packet, beams, group, s);
    else
      evaluate_materials(scene, record, packet, beams, group, s);
  }
}

}  // namespace lippmann
