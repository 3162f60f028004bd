// Where the lens array stands in a scene: as the scene's author placed it, or fitted so that the scene straddles it.
//
// Fitted to the first camera: the array's plane is square to its view, at its focus distance or, where it has none, half way
// through what lies in front of it; as high as what the camera sees there, and viewed from where the camera is, so that the
// central directional view is the camera's own picture. Without a camera: to one that sees all of the animation, from the front
// and a little from above and the right.
// The fit is made once, at frame 0; after that the array moves rigidly with the camera's (or display's) node, so that it
// neither grows nor breathes.
//
// Lengths are in units of that node (without a node: of the world): a parent that scales the camera scales the array with it.
// Of a node's transform the rotation and one scale are used, its shear and uneven scale are left out.
#pragma once

#include <string>

#include "core/math.hpp"
#include "optics/optics.hpp"
#include "scene/scene.hpp"
#include "scene/timeline.hpp"

namespace lippmann {

struct FittedArray {
  enum class Origin { kPlaced, kFocus, kSceneCenter, kBounds };
  Origin origin = Origin::kPlaced;  ///< by the author; at the camera's focus; half way through the scene; no camera
  int node = -1;                    ///< that the array moves with; -1: none
  Affine3f node_from_plane;         ///< rigid; the plane z = 0, +z towards the viewer, +y up, origin at its centre
  float plane_height = 1.0f;
  float viewing_distance = kInfinity;           ///< of the viewer in front of the plane
  float depth_front = 0.0f, depth_back = 0.0f;  ///< nearest and farthest z of the scene's finite shapes in front of the viewer,
                                                ///< at frame 0; 0 and 0 where there are none
  std::string how;                              ///< one sentence for people
};

/// aspect: width / height of the picture; only a scene without cameras is fitted to it.
/// Throws Error where the node of the camera or display is scaled to nothing.
FittedArray fit_array(const Scene& scene, float aspect = 1.0f);

/// Units of the array's node per millimetre of the display frame, where what is seen of the plane z = 0 is `height_mm` high:
/// the panel, or one view of a quilt.
inline float scene_units_per_mm(const FittedArray& array, float height_mm) { return array.plane_height / height_mm; }

/// The display frame (mm) in the world, at one moment: a similarity.
/// Throws Error where the array's node is scaled to nothing at that moment.
Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved);

}  // namespace lippmann
