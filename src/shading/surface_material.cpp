#include "shading/surface_material.hpp"

namespace lippmann {
namespace {

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
  s.any_see_through |= m.opacity < 1.0f || m.has_alpha;
}

/// The texture coordinates at the hit, and their changes a and b along the two axes of the beam, projected along the ray onto
/// the facet.
struct UvFootprint {
  Vec2f uv, a, b;
};

UvFootprint uv_footprint(const GeometryRecord& record, const RayHitPacket& packet, int i, int set, const BeamFootprint& beam,
                         Vec2f widths) {
  const Vec2f uv = at_hit(uvs_of(*record.mesh, set), record, packet, i);
  const UvGradient& gradient = (*record.uv_gradients[static_cast<std::size_t>(set)])[packet.hit.primID[i]];
  Vec3f du = gradient.du, dv = gradient.dv, n = gradient.normal;
  if (record.placed) {
    du = record.normal_from_mesh * du;
    dv = record.normal_from_mesh * dv;
    n = record.normal_from_mesh * n;
    n *= 1.0f / (glm::length(n) + 1e-20f);
  }
  const Vec3f d(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
  const float across = glm::dot(n, d);
  // Limits the footprints of surfaces seen edge-on to 16 beam widths.
  const float inverse = 1.0f / std::copysign(std::max(std::abs(across), 0.0625f), across);
  const float u_along = glm::dot(du, d) * inverse, v_along = glm::dot(dv, d) * inverse;
  // Projects the beam's axis along the ray onto the facet: axis - d (n . axis) / (n . d), with d the ray's direction and n the
  // facet's normal.
  const auto change = [&](Vec3f axis, float width) {
    const float slide = glm::dot(n, axis);
    return width * Vec2f(glm::dot(du, axis) - slide * u_along, glm::dot(dv, axis) - slide * v_along);
  };
  return {uv, change(beam.axis_x(), widths.x), change(beam.axis_y(), widths.y)};
}

void uv_footprints(const GeometryRecord& record, const RayHitPacket& packet, const TextureMap& map, const PacketBeams& beams,
                   const LaneMask& lanes, UvLanes& uv) {
  const BeamFootprint& beam = beams.footprint;
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    const float length = beams.path_length[i] + packet.ray.tfar[i];
    const Vec2f widths = beams.spread && beams.spread->lane[i] ? beam.widths(length) : beam.sample_widths(length);
    const UvFootprint f = uv_footprint(record, packet, i, map.uv_set, beam, widths);
    const Vec2f at = map.offset + map.matrix * f.uv, a = map.matrix * f.a, b = map.matrix * f.b;
    uv.u[i] = at.x, uv.v[i] = at.y;
    uv.a_u[i] = a.x, uv.a_v[i] = a.y, uv.b_u[i] = b.x, uv.b_v[i] = b.y;
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
    s.opacity[i] *= m.alpha_cutoff > 0.0f ? (m.base_alpha * alpha[i] >= m.alpha_cutoff ? 1.0f : 0.0f) : alpha[i];
  }
}

const DeviceTexture& texture(const ShadedScene& scene, int index) { return scene.textures[static_cast<std::size_t>(index)]; }

void apply_projected(const ShadedScene& scene, const WhittedMaterial& m, const Lanes& length, const LaneMask& lanes,
                     SurfacePacket& s) {
  const ImageProjection& projection = scene.materials.projections[static_cast<std::size_t>(m.projection)];
  sample_projected(texture(scene, m.color_map.texture), projection, s.position, length, lanes, s.color);
}

bool is_mapped(const TextureMap& map, const GeometryRecord& record) {
  return map.texture >= 0 && record.uv_gradients[static_cast<std::size_t>(map.uv_set)];
}

void apply_vertex_colors(const GeometryRecord& record, const RayHitPacket& packet, const LaneMask& lanes, SurfacePacket& s) {
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) s.color.set(i, s.color.get(i) * at_hit(record.mesh->colors, record, packet, i));
}

void apply_vertex_alphas(const GeometryRecord& record, const RayHitPacket& packet, const LaneMask& lanes, Lanes& alpha) {
  for (int i = 0; i < kLanes; ++i)
    if (lanes.lane[i]) alpha[i] *= at_hit(record.mesh->alphas, record, packet, i);
}

void apply_mesh(const ShadedScene& scene, const WhittedMaterial& m, const GeometryRecord& record, const RayHitPacket& packet,
                const PacketBeams& beams, const LaneMask& lanes, SurfacePacket& s) {
  UvLanes uv;
  TexelLanes texels;
  LIPPMANN_FOR_LANES(i) texels.alpha[i] = 1.0f;
  if (m.projection < 0 && is_mapped(m.color_map, record)) {
    uv_footprints(record, packet, m.color_map, beams, lanes, uv);
    sample_uv(texture(scene, m.color_map.texture), uv, lanes, texels);
    scale_texels(texels, m.color, lanes, s.color);
  }
  if (!record.mesh->colors.empty()) apply_vertex_colors(record, packet, lanes, s);
  if (m.has_alpha) {
    if (!record.mesh->alphas.empty()) apply_vertex_alphas(record, packet, lanes, texels.alpha);
    apply_alpha(m, texels.alpha, lanes, s);
  }
  if (is_mapped(m.emission_map, record)) {
    uv_footprints(record, packet, m.emission_map, beams, lanes, uv);
    sample_uv(texture(scene, m.emission_map.texture), uv, lanes, texels);
    scale_texels(texels, m.emission, lanes, s.emission);
  }
}

}  // namespace

void evaluate_material(const ShadedScene& scene, const WhittedMaterial& m, const GeometryRecord* record,
                       const RayHitPacket& packet, const PacketBeams& beams, const LaneMask& lanes, SurfacePacket& s) {
  set_material(m, lanes, s);
  const bool of_mesh = record && record->kind == GeometryKind::kMesh;
  if (m.projection >= 0 && m.color_map.texture >= 0) {
    Lanes length;
    LIPPMANN_FOR_LANES(i) length[i] = beams.path_length[i] + packet.ray.tfar[i];
    apply_projected(scene, m, length, lanes, s);
  }
  if (of_mesh) apply_mesh(scene, m, *record, packet, beams, lanes, s);
}

}  // namespace lippmann
