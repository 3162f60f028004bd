// Finds the subject of a scene. The subject is everything except the surroundings: ground, walls, ceiling, sky and backdrop.
//
// Surroundings are found only by shape and position, per instance, in world axes with +y up:
//  - A sheet is an instance that is thin along one axis and lies at a face of the scene's bounding box. The sheets at a face
//    are surroundings if they span the face together. Ground lies at the lower face. Walls lie at the side faces and extend
//    down to the ground. A ceiling rests on walls.
//  - A shell is an instance that contains everything else between its sides, with free space around the content: sky, dome,
//    backdrop, hills. Only the ground below the content may be nearer.
// Surroundings are removed only if the remaining part is much smaller than the whole.
//
// Before that, instances and triangles of static meshes are left out if they are so far away that an image of everything would
// show nothing (main_part.hpp). A scene with a single mesh has no surroundings. At least one instance always remains. Infinite
// planes have no bounds and are ignored.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

enum class InstanceRole {
  kSubject,
  kGround,    ///< ground and ceilings, which extend from the subject to the far distance
  kBackdrop,  ///< walls, sky, domes
  kUnseen,    ///< hidden from cameras
  kStray,     ///< far away from everything else
};

/// Returns whether instances with this role are visible surroundings of the subject.
bool is_surrounding(InstanceRole role);

struct Subject {
  std::vector<InstanceRole> roles;  ///< one entry per instance
  /// Box in world space. Parts outside the box are left out. Not set if nothing is left out.
  std::optional<Bounds3f> main_part;
  /// One entry per instance: true if only its part inside main_part belongs to the subject. Empty without main_part.
  std::vector<bool> is_cut;
  bool has_surroundings() const;
  bool contains(std::size_t instance) const { return roles[instance] == InstanceRole::kSubject; }
};

/// Returns the frames at which the animation is sampled: 0 and every n-th frame, at most 63 frames.
std::vector<int> sampled_frames(const Timeline& timeline);

/// Returns a subject with all visible instances.
Subject whole_scene(const Scene& scene);

/// Returns the bounds of the part of an instance that belongs to the subject. Infinite shapes are left out, as in
/// finite_bounds().
Bounds3f bounds_of_part(const Scene& scene, const Subject& subject, std::size_t instance, const ResolvedScene& resolved,
                        const Affine3f& frame_from_world = {});

/// Returns the subject of the whole animation. If all finite instances are surroundings, the subject is everything.
Subject find_subject(const Scene& scene);

inline float diagonal(const Bounds3f& bounds) { return bounds.empty() ? 0.0f : glm::length(bounds.size()); }

/// Return lists of names, such as "'Plane', 'Wall' and 3 others". list_surroundings() lists the surroundings. list_strays()
/// lists instances that are left out, completely or partly, because they are far away. list_strays() also states the number of
/// distant splats outside the bounds.
std::string list_surroundings(const Scene& scene, const Subject& subject);
std::string list_strays(const Scene& scene, const Subject& subject);

}  // namespace lippmann
