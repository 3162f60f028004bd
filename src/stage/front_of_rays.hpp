// The start of rays: at the viewer's eye, or nearer to the array's plane if the eye would see the back of a wall.
//
// The array is fitted to a viewer, which is a camera of the file or was found for the subject. The display's own viewer is
// often farther away. Through the display's frame, this viewer also sees the space between both viewers, mainly the floor in
// front of the subject. A wall behind the file's camera lies in this space, too, and would hide everything. So would a wall
// that the camera's near clipping plane cuts away.
//
// A surface is a wall if the plane of its polygon separates the near clipping plane from the eye, so the eye sees its other
// side. Both see the upper side of a floor. Rays begin just in front of an instance whose walls cover at least a quarter of the
// frame, or in front of all walls if only all of them together do. Smaller surfaces, such as a chair behind the camera, are
// shown.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct FrontOfRays {
  float z = kInfinity;  ///< start of the rays in the array's plane frame, in units of its node
  std::string cut;      ///< one sentence that names the walls in front of the start; empty if there are none
};

/// Returns the start of the rays. It is the fitted viewer's z if nothing lies between this viewer's near clipping plane and the
/// eye. aspect: width / height of the plane. eye: distance of the display's viewer in front of the plane, in the units of z.
/// Over an animation, returns the start nearest to the plane.
FrontOfRays front_of_rays(const Scene& scene, const FittedArray& array, float aspect, float eye);

}  // namespace lippmann
