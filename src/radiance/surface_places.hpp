// Where hits lie in the space of what they hit: things that move, turn or bend take along what is known of their surface.
#pragma once

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

#include "lippmann/scene/timeline.hpp"
#include "radiance/radiance_cache.hpp"
#include "shading/surface.hpp"

namespace lippmann {

/// By triangle of a mesh: the first vertex of the part that it hangs together with.
std::vector<std::uint32_t> connected_parts(const Mesh& mesh);

class SurfacePlaces {
 public:
  /// `scene` outlives it; made once, as parts take a while.
  explicit SurfacePlaces(const ShadedScene& scene);

  /// Takes everything to where it is in a frame.
  void update(const ResolvedScene& resolved);

  /// World units by which a point of a thing (both as a CachePoint has them) has moved since the update before, and lights,
  /// each as far as it shares in all light.
  float moved(std::uint32_t thing, Vec3f position) const;

  /// Whether an instance moves, as a whole or in itself.
  bool moves(std::uint32_t instance) const { return spaces_[instance].moves; }

  /// Takes an instance's points from where they are to where they were at the update before: rigid.
  Affine3f before_from_now(std::uint32_t instance) const {
    const Space& space = spaces_[instance];
    return space.world_from_own_before * inverse(space.world_from_own);
  }

  /// Sets lane i. normal: where light is asked for, world space, on the viewer's side; size: the smallest cell's, world units.
  /// `normal` goes over to the place's space, unit length.
  CachePoint operator()(const RayHitPacket& packet, const SurfacePacket& surface, int i, Vec3f& normal, float size) const;

  /// CachePoint::thing of the other sides of lane i's surface that the place is near (RadianceRecord::also). normal: as the
  /// operator has left it.
  std::array<std::uint32_t, 2> sides_near(const RayHitPacket& packet, const SurfacePacket& surface, int i, Vec3f normal) const;

 private:
  struct Space {
    bool moves = false;
    Affine3f own_from_world;  ///< lengths stay
    Affine3f world_from_own, world_from_own_before;
    bool was_seen = false;
    Mat3f own_from_world_normal{1.0f};
  };

  void update_lights();
  bool is_smooth(std::uint32_t record, std::uint32_t prim) const;

  const ShadedScene& scene_;
  std::vector<Vec3f> lights_;                                     ///< where point-like lights are
  float near_lights_moved_ = 0.0f, far_lights_moved_ = 0.0f;      ///< each by its share of the lights of its kind (LightTable)
  std::vector<Space> spaces_;                                     ///< by instance
  std::unordered_map<std::uint32_t, std::uint32_t> instance_of_;  ///< by thing: those that move
  std::map<const Mesh*, std::vector<std::uint32_t>> parts_;       ///< by mesh
  std::vector<const std::vector<std::uint32_t>*> parts_of_record_;  ///< null: no mesh
  std::vector<const Mesh*> rest_of_record_;                         ///< a posed mesh as it is unbent; else null
};

}  // namespace lippmann
