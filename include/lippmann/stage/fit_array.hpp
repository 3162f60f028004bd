// Where the lens array stands in a scene: as the scene's author placed it, or fitted so that the scene straddles it.
//
// Where the scene has cameras, the first one decides the view: the array's plane is square to it, at its focus distance or,
// where it has none, half way through the subject as far as the camera sees it; as high as what the camera sees there, and
// viewed from where the camera is, so that the central directional view is the camera's own picture. A picture that is narrower
// than the camera's shows more above and below, as far as that is needed to keep the subject that the camera shows.
// An orthographic camera shows the same height at every distance, and its viewer stands no nearer than where that is 45 degrees
// high.
// Without a camera, or where a node is named that the view is to be fitted to: from the camera's direction, or from the front
// and a little from above and the right, so near that the subject just fits into the picture in every frame, with the plane
// through its middle. Pieces that lie so far away that a picture of all would show nothing are left out, with a warning. What
// the subject is: stage/subject.hpp. stage/view_wish.hpp has what people may say instead.
// The fit is made once; after that the array moves rigidly with the camera's (or display's) node, so that it neither grows nor
// breathes. What is fitted to a node's subject is fitted in that moving frame.
//
// Lengths are in units of the world at frame 0, whatever scales the node. A scale that is animated scales the array with it.
// The rotation and one scale of a node's transform are used; its shear and uneven scale are left out.
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
  Origin origin = Origin::kPlaced;  ///< by the author; at the camera's focus; half way through what it sees; fitted to bounds
  int node = -1;                    ///< that the array moves with; -1: none
  Affine3f node_from_plane;         ///< a similarity; the plane z = 0, +z towards the viewer, +y up, origin at its centre
  float plane_height = 1.0f;
  float viewing_distance = kInfinity;  ///< how far the viewer is in front of the plane
  /// Nearest and farthest z of what the display should show sharply, in front of the viewer; 0 and 0 where there is nothing.
  /// An array placed by the author takes them from all finite shapes at frame 0. Others take them from the subject as far as it
  /// is seen, and from walls within one of its diagonals, at frame 0; a fitted subject counts over the animation.
  float depth_front = 0.0f, depth_back = 0.0f;
  bool leaves_out_surroundings = false;  ///< ground, walls or sky decide neither the plane nor, but for near walls, the depth
  /// Per instance: whether the view is about it, and not about what surrounds it or lies far away.
  std::vector<bool> is_subject;
  std::string how;      ///< one sentence for people
  std::string warning;  ///< one sentence that names what is left out because it lies far away; empty: nothing
};

/// aspect: width / height of the picture.
/// The scene must pass validate() (scene/load.hpp), which place() checks.
/// Throws Error where the node of the camera or display is scaled to nothing, a usage Error for wishes that cannot be met.
FittedArray fit_array(const Scene& scene, float aspect = 1.0f, const ViewWish& wish = {});

/// World units per millimetre of the display frame, where what is seen of the plane z = 0 is `height_mm` high:
/// the panel, or one view of a quilt.
inline float scene_units_per_mm(const FittedArray& array, float height_mm) { return array.plane_height / height_mm; }

/// The display frame (mm) in the world, at one moment: a similarity.
/// Throws Error where the array's node does not exist or is scaled to nothing at that moment.
Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved);

}  // namespace lippmann
