#include "trace/surface.hpp"

namespace lippmann {
namespace {

unsigned record_id(const RayHitPacket& packet, int i) {
  return packet.hit.instID[0][i] != kNoId ? packet.hit.instID[0][i] : packet.hit.geomID[i];
}

/// Positions, how exact they are, the mask of lanes that hit something, whether any did and whether any did not.
LIPPMANN_MULTIVERSION void place_hits(const RayHitPacket& packet, const LaneMask& active, float least_t_near,
                                      SurfacePacket& s) {
  // Rounding moves a point by some 10^-7 of its coordinates and of the ray's length.
  constexpr float kRounding = 1e-5f;
  int any = 0, all = -1;
  LIPPMANN_FOR_LANES(i) {
    const int hit = (active.lane[i] != 0) & (packet.hit.geomID[i] < kLightId) ? -1 : 0;
    s.hit.lane[i] = hit;
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

/// Turns the shading normal to the side of the geometric normal that the ray came from, and makes it unit length.
LIPPMANN_MULTIVERSION void face_ray(const RayHitPacket& packet, const Lanes3& geometric, SurfacePacket& s) {
  LIPPMANN_FOR_LANES(i) {
    const float dx = packet.ray.dir_x[i], dy = packet.ray.dir_y[i], dz = packet.ray.dir_z[i];
    const bool behind = geometric.x[i] * dx + geometric.y[i] * dy + geometric.z[i] * dz > 0.0f;
    const float nx = s.normal.x[i], ny = s.normal.y[i], nz = s.normal.z[i];
    const float squared = nx * nx + ny * ny + nz * nz;
    const float scale = (behind ? -1.0f : 1.0f) / std::sqrt(std::max(squared, 1e-30f));
    s.entering.lane[i] = behind ? 0 : -1;
    s.normal.x[i] = nx * scale, s.normal.y[i] = ny * scale, s.normal.z[i] = nz * scale;
  }
}

struct TriangleHit {
  const Mesh* mesh;
  const std::array<std::uint32_t, 3>* triangle;
  float u, v;
};

TriangleHit triangle_hit(const GeometryRecord& record, const RayHitPacket& packet, int i) {
  return {record.mesh, &record.mesh->triangles[packet.hit.primID[i]], packet.hit.u[i], packet.hit.v[i]};
}

void mesh_normal(const GeometryRecord& record, const RayHitPacket& packet, int i, Lanes3& geometric, Lanes3& shading) {
  Vec3f facet(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
  Vec3f smooth = facet;
  if (!record.mesh->normals.empty()) {
    const TriangleHit hit = triangle_hit(record, packet, i);
    const auto& [a, b, c] = *hit.triangle;
    const auto& n = record.mesh->normals;
    smooth = (1.0f - hit.u - hit.v) * n[a] + hit.u * n[b] + hit.v * n[c];
  }
  if (record.placed) {
    facet = record.normal_from_mesh * facet;
    smooth = record.normal_from_mesh * smooth;
  }
  geometric.set(i, facet);
  shading.set(i, smooth);
}

template <class Primitive>
const PrimitiveTable<Primitive>& table(const GeometryRecord& record) {
  return *static_cast<const PrimitiveTable<Primitive>*>(record.primitives);
}

Vec3f primitive_normal(const DeviceScene::Impl& scene, const GeometryRecord& record, unsigned prim, Vec3f p) {
  switch (record.kind) {
    case GeometryKind::kSpheres:
      return normal_at(table<WorldSphere>(record).primitives[prim], p);
    case GeometryKind::kCylinders:
      return normal_at(table<WorldCylinder>(record).primitives[prim], p);
    case GeometryKind::kRings:
      return normal_at(table<WorldRing>(record).primitives[prim], p);
    case GeometryKind::kBoxes: {
      const WorldBox& box = table<WorldBox>(record).primitives[prim];
      return scene.tachyon ? tachyon_box_normal(box, p) : normal_at(box, p);
    }
    case GeometryKind::kMesh:
      break;
  }
  return Vec3f(0, 0, 1);
}

std::uint32_t instance_of(const GeometryRecord& record, unsigned prim) {
  switch (record.kind) {
    case GeometryKind::kSpheres:
      return table<WorldSphere>(record).instance[prim];
    case GeometryKind::kCylinders:
      return table<WorldCylinder>(record).instance[prim];
    case GeometryKind::kRings:
      return table<WorldRing>(record).instance[prim];
    case GeometryKind::kBoxes:
      return table<WorldBox>(record).instance[prim];
    case GeometryKind::kMesh:
      break;
  }
  return record.instance;
}

/// Takes the first lane of `left`, and all those of the same key, out of it and into `group`; returns that lane, or -1 where
/// none is left.
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

LIPPMANN_INLINE void set_lanes(Lanes& to, float value, const LaneMask& lanes) {
  LIPPMANN_FOR_LANES(i) to[i] = lanes.lane[i] != 0 ? value : to[i];
}

LIPPMANN_INLINE void set_lanes(Lanes3& to, Vec3f value, const LaneMask& lanes) {
  set_lanes(to.x, value.x, lanes), set_lanes(to.y, value.y, lanes), set_lanes(to.z, value.z, lanes);
}

LIPPMANN_MULTIVERSION void set_material(const WhittedMaterial& m, const LaneMask& lanes, SurfacePacket& s) {
  set_lanes(s.color, m.color, lanes);
  set_lanes(s.ambient, m.ambient, lanes);
  set_lanes(s.emission, m.emission, lanes);
  set_lanes(s.diffuse, m.diffuse, lanes);
  set_lanes(s.highlight, m.highlight, lanes);
  set_lanes(s.highlight_size, m.highlight_size, lanes);
  set_lanes(s.highlight_cutoff, m.highlight_cutoff, lanes);
  set_lanes(s.highlight_tint, m.highlight_tint, lanes);
  set_lanes(s.mirror, m.mirror, lanes);
  set_lanes(s.mirror_tint, m.mirror_tint, lanes);
  set_lanes(s.opacity, m.opacity, lanes);
  set_lanes(s.ior, m.ior, lanes);
  s.any_highlight |= m.highlight > 0.0f;
  s.any_mirror |= m.mirror > 0.0f;
  s.any_see_through |= m.opacity < 1.0f || m.alpha_from_texture;
}

/// uv at the hit, and how it changes along the beam's two axes, each projected along the ray onto the facet.
struct UvFootprint {
  Vec2f uv, a, b;
};

/// path_length: to the hit.
UvFootprint uv_footprint(const GeometryRecord& record, const RayHitPacket& packet, int i, const BeamFootprint& beam,
                         float path_length) {
  const TriangleHit hit = triangle_hit(record, packet, i);
  const auto& [ia, ib, ic] = *hit.triangle;
  const auto& uvs = hit.mesh->uvs;
  const Vec2f uv = (1.0f - hit.u - hit.v) * uvs[ia] + hit.u * uvs[ib] + hit.v * uvs[ic];
  const UvGradient& gradient = (*record.uv_gradients)[packet.hit.primID[i]];
  Vec3f du = gradient.du, dv = gradient.dv, n = gradient.normal;
  if (record.placed) {
    du = record.normal_from_mesh * du;
    dv = record.normal_from_mesh * dv;
    n = record.normal_from_mesh * n;
    n *= 1.0f / (glm::length(n) + 1e-20f);
  }
  const Vec3f d(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
  const float across = glm::dot(n, d);
  // Seen edge-on a footprint grows without bound; 1/16 stops it at 16 widths.
  const float inverse = 1.0f / std::copysign(std::max(std::abs(across), 0.0625f), across);
  const float u_along = glm::dot(du, d) * inverse, v_along = glm::dot(dv, d) * inverse;
  const Vec2f widths = beam.widths(path_length);
  // An axis is moved along the ray onto the facet: axis - d (n . axis) / (n . d).
  const auto change = [&](Vec3f axis, float width) {
    const float slide = glm::dot(n, axis);
    return width * Vec2f(glm::dot(du, axis) - slide * u_along, glm::dot(dv, axis) - slide * v_along);
  };
  return {uv, change(beam.axis_x(), widths.x), change(beam.axis_y(), widths.y)};
}

/// The footprints of the lanes of `group` that lie on meshes with texture coordinates; takes the others out of `group`.
void uv_footprints(const DeviceScene::Impl& scene, const RayHitPacket& packet, const Lanes& length, const BeamFootprint& beam,
                   LaneMask& group, UvLanes& uv) {
  for (int i = 0; i < kLanes; ++i) {
    if (!group.lane[i]) continue;
    const unsigned id = record_id(packet, i);
    if (id >= kPlaneId || !scene.records[id].uv_gradients) {
      group.lane[i] = 0;
      continue;
    }
    const UvFootprint f = uv_footprint(scene.records[id], packet, i, beam, length[i]);
    uv.u[i] = f.uv.x, uv.v[i] = f.uv.y;
    uv.a_u[i] = f.a.x, uv.a_v[i] = f.a.y, uv.b_u[i] = f.b.x, uv.b_v[i] = f.b.y;
  }
}

LIPPMANN_INLINE void scale_lanes(const Lanes& by, float factor, const LaneMask& lanes, Lanes& to) {
  LIPPMANN_FOR_LANES(i) to[i] = lanes.lane[i] != 0 ? factor * by[i] : to[i];
}

LIPPMANN_MULTIVERSION void scale_texels(const TexelLanes& texels, Vec3f factor, const LaneMask& lanes, Lanes3& to) {
  scale_lanes(texels.color.x, factor.x, lanes, to.x);
  scale_lanes(texels.color.y, factor.y, lanes, to.y);
  scale_lanes(texels.color.z, factor.z, lanes, to.z);
}

void apply_alpha(const WhittedMaterial& m, const Lanes& alpha, const LaneMask& lanes, SurfacePacket& s) {
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    s.opacity[i] *= m.alpha_cutoff > 0.0f ? (alpha[i] >= m.alpha_cutoff ? 1.0f : 0.0f) : alpha[i];
  }
}

/// `group`: the lanes of material `m`.
void apply_textures(const DeviceScene::Impl& scene, const WhittedMaterial& m, const RayHitPacket& packet, LaneMask group,
                    const Lanes& path_length, const BeamFootprint& beam, SurfacePacket& s) {
  const auto texture = [&](int index) -> const DeviceTexture& { return scene.textures[static_cast<std::size_t>(index)]; };
  Lanes length;
  LIPPMANN_FOR_LANES(i) length[i] = path_length[i] + packet.ray.tfar[i];
  if (m.projection >= 0) {
    const ImageProjection& projection = scene.materials.projections[static_cast<std::size_t>(m.projection)];
    if (m.texture >= 0) sample_projected(texture(m.texture), projection, s.position, length, group, s.color);
    return;
  }
  UvLanes uv;
  uv_footprints(scene, packet, length, beam, group, uv);
  TexelLanes texels;
  if (m.texture >= 0) {
    sample_uv(texture(m.texture), uv, group, texels);
    scale_texels(texels, m.color, group, s.color);
    if (m.alpha_from_texture) apply_alpha(m, texels.alpha, group, s);
  }
  if (m.emission_texture >= 0) {
    sample_uv(texture(m.emission_texture), uv, group, texels);
    scale_texels(texels, m.emission, group, s.emission);
  }
}

/// Multiplies in the vertex colours of the meshes that have any.
void apply_vertex_colors(const DeviceScene::Impl& scene, const RayHitPacket& packet, SurfacePacket& s) {
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i]) continue;
    const unsigned id = record_id(packet, i);
    if (id >= kPlaneId) continue;
    const GeometryRecord& record = scene.records[id];
    if (record.kind != GeometryKind::kMesh || record.mesh->colors.empty()) continue;
    const TriangleHit hit = triangle_hit(record, packet, i);
    const auto& [a, b, c] = *hit.triangle;
    const auto& colors = record.mesh->colors;
    s.color.set(i, s.color.get(i) * ((1.0f - hit.u - hit.v) * colors[a] + hit.u * colors[b] + hit.v * colors[c]));
  }
}

void evaluate_materials(const DeviceScene::Impl& scene, const RayHitPacket& packet, const Lanes& path_length,
                        const BeamFootprint& beam, SurfacePacket& s) {
  alignas(64) std::uint32_t material[kLanes];
  for (int i = 0; i < kLanes; ++i)
    if (s.hit.lane[i]) material[i] = scene.material_of_instance[s.instance[i]];
  LaneMask left = s.hit, group;
  for (int first; (first = take_group(material, left, group)) >= 0;) {
    const WhittedMaterial& m = scene.materials.materials[material[first]];
    set_material(m, group, s);
    if (m.texture >= 0 || m.emission_texture >= 0) apply_textures(scene, m, packet, group, path_length, beam, s);
  }
}

}  // namespace

std::uint32_t hit_instance(const DeviceScene::Impl& scene, const RayHitPacket& packet, int i) {
  const unsigned id = record_id(packet, i);
  if (id >= kPlaneId) return scene.planes[id - kPlaneId].instance;
  return instance_of(scene.records[id], packet.hit.primID[i]);
}

void evaluate_geometry(const DeviceScene::Impl& scene, const RayHitPacket& packet, const LaneMask& active, SurfacePacket& s) {
  place_hits(packet, active, scene.secondary_t_near, s);
  if (!s.any_hit) return;
  Lanes3 geometric;
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i]) {
      geometric.set(i, Vec3f(0.0f)), s.normal.set(i, Vec3f(0, 0, 1));
      continue;
    }
    const unsigned id = record_id(packet, i);
    if (id >= kPlaneId) {
      const WorldPlaneRecord& plane = scene.planes[id - kPlaneId];
      s.instance[i] = plane.instance;
      const Vec3f n = normal_at(plane.plane, Vec3f());
      s.normal.set(i, n), geometric.set(i, n);
      continue;
    }
    const GeometryRecord& record = scene.records[id];
    const unsigned prim = packet.hit.primID[i];
    s.instance[i] = instance_of(record, prim);
    if (record.kind == GeometryKind::kMesh) {
      mesh_normal(record, packet, i, geometric, s.normal);
    } else {
      const Vec3f n = primitive_normal(scene, record, prim, s.position.get(i));
      s.normal.set(i, n), geometric.set(i, n);
    }
  }
  face_ray(packet, geometric, s);
}

void evaluate_surfaces(const DeviceScene::Impl& scene, const RayHitPacket& packet, const LaneMask& active,
                       const Lanes& path_length, const BeamFootprint& beam, SurfacePacket& s) {
  evaluate_geometry(scene, packet, active, s);
  s.any_highlight = s.any_mirror = s.any_see_through = false;
  if (!s.any_hit) return;
  evaluate_materials(scene, packet, path_length, beam, s);
  if (scene.any_vertex_colors) apply_vertex_colors(scene, packet, s);
}

}  // namespace lippmann
