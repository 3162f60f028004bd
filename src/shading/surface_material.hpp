// Evaluates the material terms of a packet of surface points, including textures and vertex colours.
#pragma once

#include "shading/surface.hpp"

namespace lippmann {

/// Returns a per-vertex quantity at the hit of lane i.
template <class Value>
Value at_hit(const std::vector<Value>& of_vertex, const GeometryRecord& record, const RayHitPacket& packet, int i) {
  const auto& [a, b, c] = record.mesh->triangles[packet.hit.primID[i]];
  const float u = packet.hit.u[i], v = packet.hit.v[i];
  return (1.0f - u - v) * of_vertex[a] + u * of_vertex[b] + v * of_vertex[c];
}

/// The beams of a packet's rays, for texture filtering.
struct PacketBeams {
  const BeamFootprint& footprint;
  const Lanes& path_length;  ///< length of each path up to its ray's origin
  const LaneMask* spread;    ///< lanes filtered over a whole pixel instead of a sample; null: none
};

/// Sets the material terms of `lanes`, which have all hit `record` (null: a plane) and have the same material.
void evaluate_material(const ShadedScene& scene, const WhittedMaterial& material, const GeometryRecord* record,
                       const RayHitPacket& packet, const PacketBeams& beams, const LaneMask& lanes, SurfacePacket& s);

}  // namespace lippmann
