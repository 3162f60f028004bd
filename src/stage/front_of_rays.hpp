// Computes where rays start: at the viewer's eye, or nearer to the array's plane if walls would hide the scene from the eye.
//
// The display's viewer is often farther away than the file's camera, to which the array is fitted. A wall behind that camera
// would then hide everything.
//
// A surface is a wall if the plane of its polygon separates the camera's near clipping plane from the eye, so that the eye sees
// its other side. Rays start just in front of an instance whose walls cover at least a quarter of the frame, or in front of all
// walls if only all together cover a quarter. Smaller surfaces, such as a chair behind the camera, are shown.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct FrontOfRays {
  /// z at which rays start, in the frame of the array's plane and in units of the array's node.
  float z = kInfinity;
  /// Sentence for the user that names the walls between the start of rays and the eye, or empty.
  std::string cut;
};

/// `aspect` is width / height of the array's plane, `eye` the distance of the display's viewer in units of the array's node. If
/// nothing lies between the camera's near clipping plane and the eye, rays start at the camera. For an animation, returns the
/// start that is nearest to the plane.
FrontOfRays front_of_rays(const Scene& scene, const FittedArray& array, float aspect, float eye);

}  // namespace lippmann
