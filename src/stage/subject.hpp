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
// Before that, very distant instances and triangles are left out (main_part.hpp). At least one instance always remains.
// Infinite planes are ignored.
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
  kGround,    ///< ground and ceilings
  kBackdrop,  ///< walls, sky, domes
  kUnseen,
  kStray,  ///< far away from everything else
};

bool is_surrounding(InstanceRole role);

struct Subject {
  std::vector<InstanceRole> roles;
  /// Parts outside this box (world space) are left out. Not set if no parts are left out.
  std::optional<Bounds3f> main_part;
  /// True for an instance that main_part cuts. Empty without main_part.
  std::vector<bool> is_cut;
  bool has_surroundings() const;
  bool contains(std::size_t instance) const { return roles[instance] == InstanceRole::kSubject; }
};

/// Returns the frames at which the animation is sampled: at most 63 frames at regular intervals, starting with frame 0.
std::vector<int> sampled_frames(const Timeline& timeline);

Subject whole_scene(const Scene& scene);

/// Bounds of the part of an instance that belongs to the subject, without infinite shapes.
Bounds3f bounds_of_part(const Scene& scene, const Subject& subject, std::size_t instance, const ResolvedScene& resolved,
                        const Affine3f& frame_from_world = {});

/// Finds the subject of the whole animation. If all finite instances are surroundings, the subject is everything.
Subject find_subject(const Scene& scene);

inline float diagonal(const Bounds3f& bounds) { return bounds.empty() ? 0.0f : glm::length(bounds.size()); }

/// List the surroundings, and the distant instances and splats that are left out, in the form "'Plane', 'Wall' and 3 others".
std::string list_surroundings(const Scene& scene, const Subject& subject);
std::string list_strays(const Scene& scene, const Subject& subject);

}  // namespace lippmann
