// Places the lens array in a scene: as the scene's author placed it, or fitted so that the scene extends to both sides of it.
//
// If the scene has cameras, the first one defines the view. The array's plane is perpendicular to the camera's axis, at its
// focus distance or, without one, half way through the visible part of the subject. The plane is as high as the camera's view
// there, and is viewed from the camera's position, so the central directional view equals the camera's own image. An image
// narrower than the camera's shows more above and below, as far as needed to keep the visible subject. An orthographic camera
// shows the same height at every distance; its viewer is at least so far away that this height covers 45 degrees.
// Without a camera, or if the view is fitted to a named node, the viewer looks from the camera's direction, or from the front
// and a little from above and the right. The viewer is so near that the subject just fits into the image in every frame, and
// the plane goes through the middle of the subject. Parts that are so far away that an image of everything would show nothing
// are left out, with a warning. stage/subject.hpp defines the subject; stage/view_wish.hpp has the user's options.
// The fit is made once. Afterwards, the array moves rigidly with the node of the camera or display, so its size stays constant.
// A fit to a node's subject uses that moving frame.
//
// Lengths are in world units at frame 0, regardless of the scale of nodes. An animated scale also scales the array. Of a node's
// transform, the rotation and one scale are used; shear and non-uniform scale are ignored.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

struct FittedArray {
  enum class Origin { kPlaced, kFocus, kSceneCenter, kBounds };
  /// How the plane was placed: by the author; at the camera's focus; half way through the visible part; fitted to bounds.
  Origin origin = Origin::kPlaced;
  int node = -1;  ///< node that the array moves with; -1: the array does not move
  /// Similarity from the plane's frame to the node's. In the plane's frame, the plane is z = 0, with +z towards the viewer, +y
  /// up and the origin at its centre.
  Affine3f node_from_plane{};
  float plane_height = 1.0f;
  float viewing_distance = kInfinity;  ///< distance of the viewer in front of the plane
  float near_distance = 0.0f;          ///< distance from the viewer to the camera's near clipping plane; 0: none
  /// Nearest and farthest z that the display should show sharply, z > 0 in front of the plane, limited to what lies in front of
  /// the viewer. Both are 0 if there are no finite shapes. If the author placed the array, they are the ends of all finite
  /// shapes at frame 0. Otherwise they are the ends of the visible subject, and of walls within one of its diagonals, at frame
  /// 0. For a fitted subject, they cover the whole animation.
  float depth_front = 0.0f, depth_back = 0.0f;
  /// True: ground, walls and sky do not affect the position of the plane, and only near walls affect the depth.
  bool leaves_out_surroundings = false;
  /// Per instance: true if it belongs to the subject of the view, false if it belongs to the surroundings or to distant parts
  /// that are left out.
  std::vector<bool> is_subject{};
  std::string how{};      ///< one sentence that tells the user how the array was placed
  std::string warning{};  ///< one sentence that names what is left out because it is far away; may be empty
};

/// Fits the array. aspect: width / height of the image. The scene must pass validate() (scene/load.hpp), which place() checks.
/// Throws Error if the node of the camera or display has a scale of 0, and a usage Error for options that cannot be satisfied.
FittedArray fit_array(const Scene& scene, float aspect = 1.0f, const ViewWish& wish = {});

/// Returns the world units per millimetre of the display frame, if the visible part of the plane z = 0 is `height_mm` high. The
/// visible part is the panel, or one view of a quilt.
inline float scene_units_per_mm(const FittedArray& array, float height_mm) { return array.plane_height / height_mm; }

/// Returns the transform from the display frame (mm) to the world at one time, a similarity. Throws Error if the array's node
/// does not exist or has a scale of 0 at that time.
Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved);

}  // namespace lippmann
