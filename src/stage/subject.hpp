// The subject of a scene: everything except its surroundings, which are ground, walls, ceiling, sky and backdrop.
//
// Surroundings are found by shape and position only, per instance, in world axes with +y up:
//  - Sheets: instances that are thin along one axis and lie at a face of the scene's box. The sheets at a face count if
//    together they span it. Ground lies at the lower face; walls at the side faces extend down to the ground; a ceiling rests
//    on walls.
//  - Shells: an instance that contains everything else between its sides, with free space around it: sky, dome, backdrop,
//    hills. Only the ground below may be nearer.
// Surroundings are left out if the remaining part is much smaller. Before that, instances and triangles of static meshes are
// left out if they are so far away that an image of everything would show nothing (main_part.hpp).
// A scene with a single mesh has no surroundings. At least one instance always remains.
// Infinite planes have no bounds and are ignored.
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

/// Returns whether instances of the role are visible besides the subject.
bool is_surrounding(InstanceRole role);

struct Subject {
  std::vector<InstanceRole> roles;    ///< per instance
  std::optional<Bounds3f> main_part;  ///< in world space; parts outside it are left out; not set if nothing is left out
  std::vector<bool> is_cut;           ///< per instance: only its part inside main_part counts; empty without one
  bool has_surroundings() const;
  bool contains(std::size_t instance) const { return roles[instance] == InstanceRole::kSubject; }
};

/// Returns the frames at which the animation is sampled: 0 and every n-th frame, at most 63.
std::vector<int> sampled_frames(const Timeline& timeline);

/// Returns a subject with all visible instances.
Subject whole_scene(const Scene& scene);

/// Returns the bounds of the part of an instance that counts, like finite_bounds().
Bounds3f bounds_of_part(const Scene& scene, const Subject& subject, std::size_t instance, const ResolvedScene& resolved,
                        const Affine3f& frame_from_world = {});

/// Returns the subject over the whole animation. If all finite instances are surroundings, returns everything.
Subject find_subject(const Scene& scene);

/// Returns the length of a box's diagonal, or 0 for an empty box.
inline float diagonal(const Bounds3f& bounds) { return bounds.empty() ? 0.0f : glm::length(bounds.size()); }

/// Return lists such as "'Plane', 'Wall' and 3 others": of the surroundings, and of instances that are left out as strays,
/// completely or partly, with the number of distant splats outside their bounds.
std::string list_surroundings(const Scene& scene, const Subject& subject);
std::string list_strays(const Scene& scene, const Subject& subject);

}  // namespace lippmann
