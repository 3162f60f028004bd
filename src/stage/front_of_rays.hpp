// Where rays begin: as far in front of the array's plane as the viewer's eye, unless that would show the back of a wall.
//
// The array is fitted to a viewer, who is a camera of the file or found for the subject. The display's own viewer often stands
// farther away, and sees what lies between the two through the display's frame: the floor before the subject above all. A wall
// behind the file's camera lies there, too, and would hide everything.
//
// A surface is a wall where the plane of its polygon separates the fitted viewer from the eye: the eye sees its other side. Of
// a floor, both see the upper side. An instance whose walls cover a quarter of the frame or more, or all of them together where
// none does alone, ends the space that is seen: rays begin just before it. What covers less, such as a chair behind the camera,
// is shown.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// z of the array's plane frame, in units of its node: the fitted viewer's where nothing lies between him and the eye. aspect:
/// width / height of the plane; eye: how far the display's viewer is in front of the plane, in the same units. Over the
/// animation: the nearest.
float front_of_rays(const Scene& scene, const FittedArray& array, float aspect, float eye);

}  // namespace lippmann
