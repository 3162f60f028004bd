// Places the lens array in a scene. The array is placed as the scene's author did, or fitted so that the scene extends to both
// sides of it.
//
// If the scene has cameras, the first camera defines the view:
// - The plane of the array is perpendicular to the camera's axis. It lies at the camera's focus distance. Without a focus
//   distance, it lies half way through the visible part of the subject.
// - The plane is as high as the camera's view at this distance, and the viewer is at the camera's position. The central
//   directional view therefore equals the camera's own image.
// - An image with a narrower aspect than the camera's shows more above and below, so that the visible subject still fits.
// - An orthographic camera shows the same height at every distance. Its viewer is far enough away that this height covers at
//   most 45 degrees.
//
// If the scene has no camera, or if the view is fitted to a named node, the subject defines the view:
// - The viewer looks from the camera's direction. Without a camera, the viewer looks from the front, a little from above and
//   from the right.
// - The viewer is as near as possible such that the subject fits into the image in every frame.
// - The plane goes through the middle of the subject.
// - Parts are left out, with a warning, if they are so far away that everything would be too small to see in an image of all
// parts.
//
// stage/subject.hpp defines the subject. stage/view_wish.hpp has the user's options.
//
// The array is fitted once. Afterwards it moves rigidly with the node of the camera or display.
//
// Lengths are in world units at frame 0. Shear and non-uniform scale of nodes are ignored.
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
  /// kPlaced: placed by the author. kFocus: at the camera's focus. kSceneCenter: half way through the visible part of the
  /// subject. kBounds: fitted to the bounds of the subject.
  Origin origin = Origin::kPlaced;
  /// Node that the array moves with, or -1.
  int node = -1;
  /// Similarity transform. In the frame of the plane, the plane is z = 0, its centre is the origin, +z points towards the
  /// viewer, and +y points up.
  Affine3f node_from_plane{};
  float plane_height = 1.0f;
  float viewing_distance = kInfinity;  ///< from the plane to the viewer in front of it
  /// Distance from the viewer to the near clipping plane of the camera; 0 if the camera has none.
  float near_distance = 0.0f;
  /// Nearest and farthest z that the display should show sharply. z is positive in front of the plane. Both are 0 without
  /// finite shapes. The range leaves out everything behind the viewer. It contains:
  /// - all finite shapes at frame 0, if the author placed the array,
  /// - the subject over the whole animation, and walls at most the subject's diagonal away, if the view is fitted to the
  /// subject,
  /// - the visible subject at frame 0, and walls at most its diagonal away, otherwise.
  float depth_front = 0.0f, depth_back = 0.0f;
  /// Whether the position of the plane ignores ground, walls and sky.
  bool leaves_out_surroundings = false;
  /// Per instance: true for the subject of the view, false for surroundings and distant parts.
  std::vector<bool> is_subject{};
  /// Sentence for the user on how the array was placed.
  std::string how{};
  /// Sentence that names distant parts that are left out, or empty.
  std::string warning{};
};

/// `scene` must pass validate() (scene/load.hpp). `aspect` is width / height of the image. Throws Error if the node of the
/// camera or display has a scale of 0, and a usage Error for options that cannot be satisfied.
FittedArray fit_array(const Scene& scene, float aspect = 1.0f, const ViewWish& wish = {});

/// World units per millimetre of the display frame. `height_mm` is the height of the panel, or of one view of a quilt.
inline float scene_units_per_mm(const FittedArray& array, float height_mm) { return array.plane_height / height_mm; }

/// Transform from the display frame (mm) to the world at one time. Throws Error if the array's node does not exist or has a
/// scale of 0.
Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved);

}  // namespace lippmann
