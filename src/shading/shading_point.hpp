// One lane of a packet of surface points, for path tracing: emission, scattering and transmission.
#pragma once

#include <optional>

#include "shading/surface.hpp"
#include "shading/surface_bsdf.hpp"

namespace lippmann {

struct ShadingPoint {
  Vec3f position{0.0f};
  Vec3f facet{0.0f};                      ///< normal of the facet, any length, towards the viewer
  Vec3f normal{0.0f};                     ///< smooth normal, unit length, on the side of `facet`
  const SurfacePacket* smooth = nullptr;  ///< the packet of this lane, if the mesh is smooth and opaque
  int lane = 0;
  Vec3f emission{0.0f};
  Vec3f base_color{0.0f};              ///< with textures applied
  float coverage = 1.0f;               ///< share of the light that interacts; the rest passes unchanged
  bool scatters = true;                ///< false for pure emitters
  float t_near = 0.0f;                 ///< start distance of outgoing rays
  std::uint16_t behind = kSameMedium;  ///< the medium of transmitted light
  bool disperses = false;              ///< refracts each colour channel differently
  bool is_wall = false;                ///< a thin wall; shadow rays pass it if it is smooth

  bool is_behind(Vec3f direction) const { return glm::dot(facet, direction) < 0.0f; }
  /// Returns whether a lamp in this direction lies behind the facet, but still lights the smooth surface. lift() is the offset
  /// to that surface.
  bool rises_to(Vec3f direction) const {
    return smooth && is_behind(direction) && glm::dot(normal, direction) > 0.0f && lift() != Vec3f(0.0f);
  }
  Vec3f lift() const { return smooth_lift(*smooth, lane); }
};

/// Returns lane i of a packet that was hit. The scene must be built for paths.
ShadingPoint shading_point(const ShadedScene& scene, const SurfacePacket& surface, int i);

/// Returns the direction from the hit of lane i to the viewer.
inline Vec3f view_of(const RayHitPacket& packet, int i) {
  return -Vec3f(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
}

/// Returns the metallic-roughness base of a surface that has no other layers or is purely diffuse. Returns nothing for any
/// other surface.
std::optional<MetalRoughPoint> base_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface,
                                       int i);

/// Returns the BSDF of the point for any surface model.
Bsdf bsdf_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);

}  // namespace lippmann
