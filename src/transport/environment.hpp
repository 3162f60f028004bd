// Light from infinitely far away: a panorama or a scene's gradient, its radiance along a direction, and directions drawn where
// it is bright.
//
// Panoramas are equirectangular, row 0 straight up (+y), the middle column along +x, the column at three quarters along +z (as
// Blender shows them to a scene that it has imported from glTF).
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// Directions side by side, whose light is looked up together in a fraction of the time.
struct SkyRays {
  static constexpr int kRays = 16;
  alignas(64) float x[kRays], y[kRays], z[kRays];           ///< unit vectors
  alignas(64) float red[kRays], green[kRays], blue[kRays];  ///< the radiance along them
};

class Environment {
 public:
  /// `background` must outlive it.
  explicit Environment(const Background& background);

  /// Along a unit vector; panoramas bilinear.
  Vec3f radiance(Vec3f direction) const;
  /// Along all of `rays`, to the same bits.
  void radiance(SkyRays& rays) const;

  struct Sample {
    Vec3f direction{0.0f};
    float density = 0.0f;  ///< per steradian
  };
  /// Not where is_dark().
  Sample sample(Vec2f u) const;
  /// The density of sample() along a unit vector, per steradian; 0 where is_dark().
  float density(Vec3f direction) const;

  bool is_dark() const { return rows_.empty(); }
  /// Mean over all directions.
  Vec3f mean_radiance() const { return mean_radiance_; }

 private:
  Vec3f texel(int x, int y) const;

  const Background& background_;
  int width_, height_;  ///< of the sampling grid: that of the panorama
  DiscreteDistribution rows_;
  std::vector<DiscreteDistribution> columns_;  ///< per row
  std::vector<float> cosines_;                 ///< of the polar angle at the top of each row, and at the bottom of the last
  std::vector<float> solid_angles_;            ///< of one texel, per row
  Vec3f mean_radiance_{0.0f};
};

}  // namespace lippmann
