// One lane of a packet of surface points as a path sees it: what shines there, how it scatters, what lets light through.
#pragma once

#include <optional>

#include "shading/surface.hpp"
#include "shading/surface_bsdf.hpp"

namespace lippmann {

struct ShadingPoint {
  Vec3f position{0.0f};
  Vec3f facet{0.0f};                      ///< normal of the facet, of any length, towards the viewer
  Vec3f normal{0.0f};                     ///< smooth, unit length, on the same side
  const SurfacePacket* smooth = nullptr;  ///< whose lane this is, where a mesh is to look smooth and lets no light through
  int lane = 0;
  Vec3f emission{0.0f};
  Vec3f base_color{0.0f};              ///< textures looked up
  float coverage = 1.0f;               ///< the rest of the light passes as if nothing were here
  bool scatters = true;                ///< false: it only shines
  float t_near = 0.0f;                 ///< rays that leave start so far away
  std::uint16_t behind = kSameMedium;  ///< the medium that light is in which has gone through the surface
  bool disperses = false;              ///< each colour goes its own way
  bool is_wall = false;                ///< thin, and shadow rays pass it where it is smooth

  bool is_behind(Vec3f direction) const { return glm::dot(facet, direction) < 0.0f; }
  /// Whether a lamp in that direction, behind the facet, still shines on the smooth surface, which is as far away as lift().
  bool rises_to(Vec3f direction) const {
    return smooth && is_behind(direction) && glm::dot(normal, direction) > 0.0f && lift() != Vec3f(0.0f);
  }
  Vec3f lift() const { return smooth_lift(*smooth, lane); }
};

/// Lane i of surfaces that were hit (of scenes made for paths).
ShadingPoint shading_point(const ShadedScene& scene, const SurfacePacket& surface, int i);

/// The direction that lane i is seen from.
inline Vec3f view_of(const RayHitPacket& packet, int i) {
  return -Vec3f(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
}

/// What its surface is made of where that is the base of metallic roughness alone, or scatters by Lambert's law alone; else
/// none.
std::optional<MetalRoughPoint> base_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface,
                                       int i);

/// How the point scatters, whichever surface it has.
Bsdf bsdf_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);

}  // namespace lippmann
