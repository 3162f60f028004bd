// Makes random scenes with objects, materials, lights and motion, for training data.
//
// Every random number is a hash of the seed, the index of the sample and the count of numbers drawn before. A sample therefore
// does not depend on other samples.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

class SampleRandom {
 public:
  SampleRandom(std::uint32_t seed, std::uint32_t index) : seed_(seed), index_(index) {}

  float between(float low, float high) { return low + (high - low) * unit_float(hash(seed_, index_, drawn_++)); }
  /// Returns an integer from 0 to count - 1.
  int below(int count) { return static_cast<int>(between(0.0f, static_cast<float>(count))); }
  Vec3f color(float low, float high);
  /// Returns a uniformly distributed rotation.
  Quatf turn();

 private:
  std::uint32_t seed_, index_, drawn_ = 0;
};

/// A grid of cameras, and the lengths from which disparities are computed.
struct DatasetCameras {
  Optics optics;
  float distance_mm = 0.0f;  ///< distance from every camera to the plane of zero disparity
  float baseline_mm = 0.0f;  ///< distance between neighbouring cameras
  float pixel_mm = 0.0f;     ///< size of a pixel of a view in the plane of zero disparity
};

/// Returns the triangle meshes of a scene. Each mesh is fitted into the unit sphere. Skins, morph targets and materials are
/// left out.
std::vector<Mesh> unit_meshes_of(const Scene& scene);

/// Returns a random scene with two frames. Only frame 1 is meant to be rendered; frame 0 gives the motion. Instance 0 is a wall
/// behind everything. All other instances are objects made of `meshes`, spheres and boxes. The display stands in the middle, 10
/// units high, with a random rotation.
Scene dataset_scene(const std::vector<Mesh>& meshes, SampleRandom& random);

/// Returns a random grid of cameras, 150 to 400 mm from the plane of zero disparity. In this plane, the views are 64 mm high.
/// Seen from this plane, neighbouring cameras are 0.5 to 2.5 degrees apart.
DatasetCameras dataset_cameras(ViewGrid grid, Vec2i view_size, SampleRandom& random);

}  // namespace lippmann
