// A scene drawn at random: objects, materials, lights and motion, for training data.
//
// Every number is a hash of the seed, the index of the sample and the number's place in the order of drawing: a sample does not
// depend on which others are made.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Draws numbers for one sample.
class SampleRandom {
 public:
  SampleRandom(std::uint32_t seed, std::uint32_t index) : seed_(seed), index_(index) {}

  float between(float low, float high) { return low + (high - low) * unit_float(hash(seed_, index_, drawn_++)); }
  /// 0 ... count - 1.
  int below(int count) { return static_cast<int>(between(0.0f, static_cast<float>(count))); }
  Vec3f color(float low, float high);
  /// A rotation, each equally likely.
  Quatf turn();

 private:
  std::uint32_t seed_, index_, drawn_ = 0;
};

/// A grid of cameras, and what disparities follow from.
struct DatasetCameras {
  Optics optics;
  float distance_mm = 0.0f;  ///< from every camera to the plane where views coincide
  float baseline_mm = 0.0f;  ///< between neighbours
  float pixel_mm = 0.0f;     ///< of a view, in that plane
};

/// Triangle meshes of a scene, without skins, morph targets and materials, each moved and scaled into the unit sphere.
std::vector<Mesh> unit_meshes_of(const Scene& scene);

/// Two frames: frame 0 is before, frame 1 is shown. Instance 0 is a wall behind everything, the others are objects: `meshes`,
/// spheres and boxes. The display stands in the middle, 10 units high, turned at random.
Scene dataset_scene(const std::vector<Mesh>& meshes, SampleRandom& random);

/// Cameras in a grid: distances from 150 to 400 mm to a plane that is 64 mm high, neighbours 0.5 to 2.5 degrees apart as seen
/// from there.
DatasetCameras dataset_cameras(ViewGrid grid, Vec2i view_size, SampleRandom& random);

}  // namespace lippmann
