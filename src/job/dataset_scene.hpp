// Makes random scenes with objects, materials, lights and motion, for training data.
//
// Every number is a hash of the seed, the index of the sample and the count of numbers drawn before. A sample therefore does
// not depend on the other samples.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Draws random numbers for one sample.
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

/// A grid of cameras, and the lengths that determine disparities.
struct DatasetCameras {
  Optics optics;
  float distance_mm = 0.0f;  ///< from every camera to the plane of zero disparity
  float baseline_mm = 0.0f;  ///< between neighbouring cameras
  float pixel_mm = 0.0f;     ///< size of a view's pixel in that plane
};

/// Returns the triangle meshes of a scene, each fitted into the unit sphere, without skins, morph targets and materials.
std::vector<Mesh> unit_meshes_of(const Scene& scene);

/// Makes a scene of two frames, of which frame 1 is to be rendered. Instance 0 is a wall behind everything; all other instances
/// are objects made of `meshes`, spheres and boxes. The display stands in the middle, 10 units high, with a random rotation.
Scene dataset_scene(const std::vector<Mesh>& meshes, SampleRandom& random);

/// Makes a grid of cameras at a distance of 150 to 400 mm from the plane of zero disparity, in which the views are 64 mm high.
/// Seen from that plane, neighbouring cameras are 0.5 to 2.5 degrees apart.
DatasetCameras dataset_cameras(ViewGrid grid, Vec2i view_size, SampleRandom& random);

}  // namespace lippmann
