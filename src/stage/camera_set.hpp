// Replaces a scene's cameras by cameras around its subject, to render data sets for NeRF and splats.
//
// The scene is held still at the start of its animation, and each frame shows it from another camera. All cameras look at the
// middle of the subject from the same distance, at which a ball around the subject fits into the picture.
//
// Based on: Gonzalez, Measurement of areas on a sphere using Fibonacci and latitude-longitude lattices, 2010, for the sphere.
#pragma once

#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class CameraPath {
  kSphere,      ///< evenly over the whole sphere, from top to bottom
  kHemisphere,  ///< the upper half of the sphere
  kCircle,      ///< one full circle, 20 degrees above the subject's middle
};

struct CameraSet {
  CameraPath path = CameraPath::kSphere;
  int count = 1;
  bool operator==(const CameraSet&) const = default;
};

inline constexpr int kMostCameras = 10000;

/// Parses a text such as "sphere:100". Throws a usage Error naming `where`.
CameraSet read_camera_set(const std::string& text, const std::string& where);
std::string write_camera_set(const CameraSet& set);

/// Returns the unit vectors from the subject to the cameras, +y up.
std::vector<Vec3d> camera_directions(const CameraSet& set);

/// Returns for each camera whether it is for testing. `seed` chooses an eighth of the cameras, and at least one if there are
/// two or more.
std::vector<bool> test_cameras(int count, std::uint32_t seed);

/// Replaces the cameras and the animation of a scene. The new cameras have the vertical field of view of the scene's first
/// camera, or 45 degrees if it has none. Throws Error if the scene has no finite shapes.
void surround_with_cameras(Scene& scene, const CameraSet& set);

}  // namespace lippmann
