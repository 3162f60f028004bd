// What a scene is about: everything but its surroundings, which are ground, walls, ceiling, sky and backdrop.
//
// Surroundings are found by their shape and place alone, instance by instance, in world axes with +y up:
//  - Sheets: instances that are thin along one axis and lie at a face of the box around everything. The sheets at a face count
//    if together they span it. Ground lies at the lower face; walls reach down to the ground at the faces on the sides; a
//    ceiling rests on walls.
//  - Shells: an instance that contains everything else between its sides, with free space around it: sky, dome, backdrop,
//    hills. Only the ground below may be nearer.
// They are left out if what remains is much smaller. Before that, pieces are left out that lie so far away that a picture of
// all would show nothing (main_part.hpp): instances, and triangles of meshes that do not move.
// No surroundings are left out of a scene that is one mesh, and never everything.
// Infinite planes have no bounds and decide nothing.
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
  kGround,    ///< ground and ceilings: in a picture they reach from the subject to the far distance
  kBackdrop,  ///< walls, sky, domes
  kUnseen,    ///< hidden from cameras
  kStray,     ///< far away from everything else
};

/// Whether it is seen beside the subject.
bool is_surrounding(InstanceRole role);

struct Subject {
  std::vector<InstanceRole> roles;    ///< per instance
  std::optional<Bounds3f> main_part;  ///< in the world: what lies beyond it has been left out; none: nothing has
  std::vector<bool> is_cut;           ///< per instance, where there is a main part: only what lies in it counts
  bool has_surroundings() const;
  bool contains(std::size_t instance) const { return roles[instance] == InstanceRole::kSubject; }
};

/// The frames at which a scene's animation is looked at, at most 63 of them: 0 and every n-th from there.
std::vector<int> sampled_frames(const Timeline& timeline);

/// All that is seen is subject.
Subject whole_scene(const Scene& scene);

/// Bounds of an instance's part that counts, as finite_bounds() has them.
Bounds3f bounds_of_part(const Scene& scene, const Subject& subject, std::size_t instance, const ResolvedScene& resolved,
                        const Affine3f& frame_from_world = {});

/// The subject over the whole animation. Without anything finite but surroundings: everything.
Subject find_subject(const Scene& scene);

/// The length of a box's diagonal; 0 of an empty one.
inline float diagonal(const Bounds3f& bounds) { return bounds.empty() ? 0.0f : glm::length(bounds.size()); }

/// "'Plane', 'Wall' and 3 others": the instances that are surroundings; and those that have been left out as stray, or partly
/// so, with the number of splats that their bounds leave out as far away.
std::string list_surroundings(const Scene& scene, const Subject& subject);
std::string list_strays(const Scene& scene, const Subject& subject);

}  // namespace lippmann
