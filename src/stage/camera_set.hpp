// Cameras around a scene's subject, in place of its own: data sets of NeRF and splats.
//
// The scene is held still at the start of its animation, and each frame shows it from another camera. All cameras look at the
// middle of the subject from one distance, at which the ball around the subject fits into the picture.
//
// Based on: Gonzalez, Measurement of areas on a sphere using Fibonacci and latitude-longitude lattices, 2010, for the sphere.
#pragma once

#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class CameraPath {
  kSphere,      ///< all around, evenly, from the top to the bottom
  kHemisphere,  ///< the upper half of the sphere
  kCircle,      ///< one round, 20 degrees above the middle
};

struct CameraSet {
  CameraPath path = CameraPath::kSphere;
  int count = 1;
  bool operator==(const CameraSet&) const = default;
};

inline constexpr int kMostCameras = 10000;

/// Reads "sphere:100". Throws a usage Error naming `where`.
CameraSet read_camera_set(const std::string& text, const std::string& where);
std::string write_camera_set(const CameraSet& set);

/// Unit vectors from the subject to the cameras, +y up.
std::vector<Vec3d> camera_directions(const CameraSet& set);

/// Which cameras are for testing: an eighth of them, at least one of two or more, chosen by `seed`.
std::vector<bool> test_cameras(int count, std::uint32_t seed);

/// Replaces the cameras and the animation of a scene. The angle is that of its first camera, or 45 degrees. Throws Error if
/// there is nothing finite to look at.
void surround_with_cameras(Scene& scene, const CameraSet& set);

}  // namespace lippmann
