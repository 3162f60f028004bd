// Replaces a scene's cameras by cameras around its subject, to render data sets for NeRF and splats.
//
// The scene is frozen at the start of its animation, and each frame shows it from another camera. All cameras look at the
// middle of the subject, at the distance from which a ball around the subject fits into the picture.
//
// Cameras on the sphere are based on: Gonzalez, Measurement of areas on a sphere using Fibonacci and latitude-longitude
// lattices, 2010.
#pragma once

#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class CameraPath {
  kSphere,
  kHemisphere,
  kCircle,  ///< a circle around the subject, at an elevation of 20 degrees
};

struct CameraSet {
  CameraPath path = CameraPath::kSphere;
  int count = 1;
  bool operator==(const CameraSet&) const = default;
};

inline constexpr int kMostCameras = 10000;

/// Parses text such as "sphere:100". Throws a usage Error naming `where`.
CameraSet read_camera_set(const std::string& text, const std::string& where);
std::string write_camera_set(const CameraSet& set);

/// Returns the unit vectors from the subject to each camera. +y is up.
std::vector<Vec3d> camera_directions(const CameraSet& set);

/// Marks a random eighth of the cameras as test cameras, but at least one if there are two or more cameras.
std::vector<bool> test_cameras(int count, std::uint32_t seed);

/// Replaces the scene's cameras by `set`. The new cameras have the vertical field of view of the scene's first camera, or 45
/// degrees. Throws Error if the scene has no finite shapes.
void surround_with_cameras(Scene& scene, const CameraSet& set);

}  // namespace lippmann
