#include "trace/surface.hpp"

namespace lippmann {
namespace {

LIPPMANN_INLINE LaneRay lane_ray(const RTCRay16& ray, int i) {
  return {ray.org_x[i], ray.org_y[i], ray.org_z[i], ray.dir_x[i], ray.dir_y[i], ray.dir_z[i], ray.tnear[i], ray.tfar[i]};
}

unsigned record_id(const RayHitPacket& packet, int i) {
  return packet.hit.instID[0][i] != kNoId ? packet.hit.instID[0][i] : packet.hit.geomID[i];
}

LIPPMANN_MULTIVERSION void meet_plane(const WorldPlane& plane, unsigned id, const LaneMask& active, RayHitPacket& packet) {
  LIPPMANN_FOR_LANES(i) {
    const float t = distance(plane, lane_ray(packet.ray, i));
    const bool hit = (active.lane[i] != 0) & (t < kInfinity);
    packet.ray.tfar[i] = hit ? t : packet.ray.tfar[i];
    packet.hit.geomID[i] = hit ? id : packet.hit.geomID[i];
  }
}

/// Ends the active shadow rays that cross a plane, or weakens them where it is see-through.
LIPPMANN_MULTIVERSION void cross_plane(const WorldPlane of_scene, float transmittance, const LaneMask& active,
                                       RayPacket& packet, float* passed) {
  const WorldPlane plane = of_scene;
  const float ends = transmittance > 0.0f ? kInfinity : -kInfinity;
  LIPPMANN_FOR_LANES(i) {
    const bool crossed = (active.lane[i] != 0) & (distance(plane, lane_ray(packet, i)) < kInfinity);
    passed[i] *= crossed ? transmittance : 1.0f;
    packet.tfar[i] = std::min(packet.tfar[i], crossed ? ends : kInfinity);
  }
}

/// Positions, how exact they are, the mask of lanes that hit something.
LIPPMANN_MULTIVERSION bool place_hits(const RayHitPacket& packet, const LaneMask& active, float least_t_near,
                                      SurfacePacket& s) {
  // Rounding moves a point by some 10^-7 of its coordinates and of the ray's length.
  constexpr float kRounding = 1e-5f;
  int any = 0;
  LIPPMANN_FOR_LANES(i) {
    const int hit = (active.lane[i] != 0) & (packet.hit.geomID[i] < kLightId) ? -1 : 0;
    s.hit.lane[i] = hit;
    any |= hit;
    const float t = packet.ray.tfar[i];
    s.position.x[i] = packet.ray.org_x[i] + t * packet.ray.dir_x[i];
    s.position.y[i] = packet.ray.org_y[i] + t * packet.ray.dir_y[i];
    s.position.z[i] = packet.ray.org_z[i] + t * packet.ray.dir_z[i];
    const float farthest = std::max(std::max(std::abs(s.position.x[i]), std::abs(s.position.y[i])), std::abs(s.position.z[i]));
    s.t_near[i] = std::max(least_t_near, kRounding * std::max(farthest, t));
  }
  return any != 0;
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

void set_material(const WhittedMaterial& m, int i, SurfacePacket& s) {
  s.color.set(i, m.color);
  s.ambient.set(i, m.ambient);
  s.emission.set(i, m.emission);
  s.diffuse[i] = m.diffuse;
  s.highlight[i] = m.highlight, s.highlight_size[i] = m.highlight_size;
  s.highlight_cutoff[i] = m.highlight_cutoff, s.highlight_tint[i] = m.highlight_tint;
  s.mirror[i] = m.mirror, s.mirror_tint[i] = m.mirror_tint;
  s.opacity[i] = m.opacity, s.ior[i] = m.ior;
}

LIPPMANN_MULTIVERSION void set_material_of_all(const WhittedMaterial& m, SurfacePacket& s) {
  LIPPMANN_FOR_LANES(i) {
    s.color.x[i] = m.color.x, s.color.y[i] = m.color.y, s.color.z[i] = m.color.z;
    s.ambient.x[i] = m.ambient.x, s.ambient.y[i] = m.ambient.y, s.ambient.z[i] = m.ambient.z;
    s.emission.x[i] = m.emission.x, s.emission.y[i] = m.emission.y, s.emission.z[i] = m.emission.z;
    s.diffuse[i] = m.diffuse;
    s.highlight[i] = m.highlight, s.highlight_size[i] = m.highlight_size;
    s.highlight_cutoff[i] = m.highlight_cutoff, s.highlight_tint[i] = m.highlight_tint;
    s.mirror[i] = m.mirror, s.mirror_tint[i] = m.mirror_tint;
    s.opacity[i] = m.opacity, s.ior[i] = m.ior;
  }
}

/// uv at the hit, and how it changes along the beam's two axes, each projected along the ray onto the facet.
struct UvFootprint {
  Vec2f uv, a, b;
};

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

void apply_textures(const DeviceScene::Impl& scene, const WhittedMaterial& m, const RayHitPacket& packet, int i,
                    float path_length, const BeamFootprint& beam, SurfacePacket& s) {
  const float length = path_length + packet.ray.tfar[i];
  if (m.projection >= 0) {
    if (m.texture >= 0)
      s.color.set(
          i, sample_projected(scene.textures[static_cast<std::size_t>(m.texture)],
                              scene.materials.projections[static_cast<std::size_t>(m.projection)], s.position.get(i), length));
    return;
  }
  const unsigned id = record_id(packet, i);
  if (id >= kPlaneId) return;
  const GeometryRecord& record = scene.records[id];
  if (record.kind != GeometryKind::kMesh || record.mesh->uvs.empty()) return;
  const UvFootprint f = uv_footprint(record, packet, i, beam, length);
  if (m.texture >= 0) {
    const Vec4f texel = sample_uv(scene.textures[static_cast<std::size_t>(m.texture)], f.uv, f.a, f.b);
    s.color.set(i, m.color * Vec3f(texel));
    if (m.alpha_from_texture) {
      const float alpha = m.alpha_cutoff > 0.0f ? (texel.a >= m.alpha_cutoff ? 1.0f : 0.0f) : texel.a;
      s.opacity[i] *= alpha;
    }
  }
  if (m.emission_texture >= 0)
    s.emission.set(i,
                   m.emission * Vec3f(sample_uv(scene.textures[static_cast<std::size_t>(m.emission_texture)], f.uv, f.a, f.b)));
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
  // Most packets lie on one material; then its terms are broadcast, else each lane's are looked up.
  std::uint32_t first = ~0u;
  bool uniform = true;
  std::uint32_t material[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i]) continue;
    material[i] = scene.material_of_instance[s.instance[i]];
    if (first == ~0u) first = material[i];
    uniform &= material[i] == first;
  }
  const auto note = [&](const WhittedMaterial& m) {
    s.any_highlight |= m.highlight > 0.0f;
    s.any_mirror |= m.mirror > 0.0f;
    s.any_see_through |= m.opacity < 1.0f || m.alpha_from_texture;
  };
  const auto& materials = scene.materials.materials;
  set_material_of_all(materials[first], s);
  note(materials[first]);
  if (uniform && materials[first].texture < 0 && materials[first].emission_texture < 0) return;
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i]) continue;
    const WhittedMaterial& m = materials[material[i]];
    if (!uniform) {
      set_material(m, i, s);
      note(m);
    }
    if (m.texture >= 0 || m.emission_texture >= 0) apply_textures(scene, m, packet, i, path_length[i], beam, s);
  }
}

}  // namespace

std::uint32_t hit_instance(const DeviceScene::Impl& scene, const RayHitPacket& packet, int i) {
  const unsigned id = record_id(packet, i);
  if (id >= kPlaneId) return scene.planes[id - kPlaneId].instance;
  return instance_of(scene.records[id], packet.hit.primID[i]);
}

void intersect_planes(const DeviceScene::Impl& scene, const LaneMask& active, RayHitPacket& packet) {
  for (std::size_t p = 0; p < scene.planes.size(); ++p)
    meet_plane(scene.planes[p].plane, kPlaneId + static_cast<unsigned>(p), active, packet);
}

void occlude_by_planes(const DeviceScene::Impl& scene, const LaneMask& active, RayPacket& packet, ShadowContext& context) {
  for (const WorldPlaneRecord& record : scene.planes) {
    const WhittedMaterial& material = scene.materials.materials[scene.material_of_instance[record.instance]];
    cross_plane(record.plane, shadow_transmittance(material), active, packet, context.transmittance);
  }
}

void evaluate_geometry(const DeviceScene::Impl& scene, const RayHitPacket& packet, const LaneMask& active, SurfacePacket& s) {
  s.any_hit = place_hits(packet, active, scene.secondary_t_near, s);
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
