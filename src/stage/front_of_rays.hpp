// Computes where rays start: at the viewer's eye, or nearer to the array's plane if walls would hide the scene from the eye.
//
// The array is fitted to a viewer, which is a camera of the file or was found for the subject. The display's own viewer is
// often farther away. Through the frame of the display, the display's viewer also sees the space between both viewers. This
// space shows mainly the floor in front of the subject. But a wall behind the file's camera also lies in this space, and would
// hide everything. So would a wall that the camera's near clipping plane cuts away.
//
// A surface is a wall if the plane of its polygon separates the near clipping plane from the eye, so that the eye sees its
// other side. A floor is no wall, because camera and eye both see its upper side. Rays start just in front of an instance whose
// walls cover at least a quarter of the frame. If only all walls together cover a quarter, rays start in front of all walls.
// Smaller surfaces, such as a chair behind the camera, are shown.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct FrontOfRays {
  /// z at which rays start, in the frame of the array's plane and in units of its node.
  float z = kInfinity;
  /// One sentence that names the walls between the start of rays and the eye. Empty if there are none.
  std::string cut;
};

/// Returns where rays start. If nothing lies between the near clipping plane of the fitted viewer and the eye, rays start at
/// the fitted viewer. `aspect` is width / height of the plane. `eye` is the distance of the display's viewer in front of the
/// plane, in units of the array's node. For an animation, returns the start that is nearest to the plane.
FrontOfRays front_of_rays(const Scene& scene, const FittedArray& array, float aspect, float eye);

}  // namespace lippmann
