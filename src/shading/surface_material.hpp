#pragma once

#include "shading/surface.hpp"

namespace lippmann {

template <class Value>
Value at_hit(const std::vector<Value>& of_vertex, const GeometryRecord& record, const RayHitPacket& packet, int i) {
  const auto& [a, b, c] = record.mesh->triangles[packet.hit.primID[i]];
  const float u = packet.hit.u[i], v = packet.hit.v[i];
  return (1.0f - u - v) * of_vertex[a] + u * of_vertex[b] + v * of_vertex[c];
}

struct PacketBeams {
  const BeamFootprint& footprint;
  const Lanes& path_length;
  const LaneMask* spread;  ///< lanes whose textures are filtered over a whole pixel instead of a sample; null: no lanes
};

/// Sets the material terms of `lanes`, which all have the same material. They have all hit `record`, or a plane if `record` is
/// null.
void evaluate_material(const ShadedScene& scene, const WhittedMaterial& material, const GeometryRecord* record,
                       const RayHitPacket& packet, const PacketBeams& beams, const LaneMask& lanes, SurfacePacket& s);

}  // namespace lippmann
