// Where the lens array stands in a scene: as the scene's author placed it, or fitted so that the scene straddles it.
//
// Fitted to the first camera: the array's plane is perpendicular to its view, at its focus distance or, where it has none,
// through the middle of the scene; as high as what the camera sees there. Without a camera: upright through the scene's centre.
// The fit is made once, at the start of the animation, and then moves rigidly with the camera's (or display's) node, so that
// the array neither grows nor breathes.
#pragma once

#include "core/math.hpp"
#include "scene/scene.hpp"
#include "scene/timeline.hpp"

namespace lippmann {

struct FittedArray {
  enum class Origin { kPlaced, kFocus, kSceneCenter, kBounds };
  Origin origin = Origin::kPlaced;  ///< by the author; at the camera's focus; through the centre, seen by the camera; no camera
  int node = -1;                    ///< that the array moves with; -1: none
  Affine3f node_from_plane;         ///< rigid; the plane z = 0, +z towards the viewer, +y up, origin at its centre
  float plane_height = 1.0f;        ///< scene units
  float viewing_distance = kInfinity;  ///< of the viewer in front of the plane, scene units
};

FittedArray fit_array(const Scene& scene);

/// Scene units per millimetre of the display frame, where what is seen of the plane z = 0 is `height_mm` high: the panel, or
/// one view of a quilt.
inline float scene_units_per_mm(const FittedArray& array, float height_mm) { return array.plane_height / height_mm; }

/// The display frame (mm) in the world, at one moment: a similarity.
Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved);

}  // namespace lippmann
