// Makes random scenes with objects, materials, lights and motion, for training data.
//
// Every random number is a hash of the seed, the sample's index and the count of numbers drawn for this sample, so samples are
// independent of each other.
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
  int below(int count) { return static_cast<int>(between(0.0f, static_cast<float>(count))); }
  Vec3f color(float low, float high);
  Quatf turn();

 private:
  std::uint32_t seed_, index_, drawn_ = 0;
};

struct DatasetCameras {
  Optics optics;
  float distance_mm = 0.0f;  ///< from every camera to the plane of zero disparity
  float baseline_mm = 0.0f;
  float pixel_mm = 0.0f;  ///< size of a pixel of a view in the plane of zero disparity
};

/// Returns the triangle meshes of a scene, each fitted into the unit sphere, without skins, morph targets and materials.
std::vector<Mesh> unit_meshes_of(const Scene& scene);

/// Returns a random scene with two frames. Render only frame 1; frame 0 gives the motion. Instance 0 is a wall behind all
/// objects. The objects are made of `meshes`, spheres and boxes. The display is 10 units high and has a random rotation.
Scene dataset_scene(const std::vector<Mesh>& meshes, SampleRandom& random);

/// Returns a random grid of cameras, 150 to 400 mm from the plane of zero disparity. In this plane, views are 64 mm high. Seen
/// from this plane, neighbouring cameras are 0.5 to 2.5 degrees apart.
DatasetCameras dataset_cameras(ViewGrid grid, Vec2i view_size, SampleRandom& random);

}  // namespace lippmann
