#pragma once

#include <optional>

#include "shading/surface.hpp"
#include "shading/surface_bsdf.hpp"

namespace lippmann {

struct ShadingPoint {
  Vec3f position{0.0f};
  Vec3f facet{0.0f};
  Vec3f normal{0.0f};
  /// The packet of the point, if the mesh has vertex normals and transmits no light; otherwise null
  const SurfacePacket* smooth = nullptr;
  int lane = 0;
  Vec3f emission{0.0f};
  Vec3f base_color{0.0f};
  float coverage = 1.0f;  ///< fraction of light that interacts with the surface; the rest passes unchanged
  bool scatters = true;   ///< false for pure emitters
  float t_near = 0.0f;
  std::uint16_t behind = kSameMedium;
  bool disperses = false;
  bool is_wall = false;  ///< the surface is a thin wall; shadow rays pass smooth walls

  bool is_behind(Vec3f direction) const { return glm::dot(facet, direction) < 0.0f; }
  /// Returns whether a lamp in this direction is behind the facet, but in front of the smooth surface. Shadow rays to this lamp
  /// must start at position + lift().
  bool rises_to(Vec3f direction) const {
    return smooth && is_behind(direction) && glm::dot(normal, direction) > 0.0f && lift() != Vec3f(0.0f);
  }
  Vec3f lift() const { return smooth_lift(*smooth, lane); }
};

ShadingPoint shading_point(const ShadedScene& scene, const SurfacePacket& surface, int i);

inline Vec3f view_of(const RayHitPacket& packet, int i) {
  return -Vec3f(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
}

/// Returns the metallic-roughness description of a surface without other layers, or of a purely diffuse surface. Returns
/// nothing for any other surface.
std::optional<MetalRoughPoint> base_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface,
                                       int i);

Bsdf bsdf_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);

}  // namespace lippmann
