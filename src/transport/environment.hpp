// Light from infinitely far away: a panorama or a gradient. Evaluates its radiance, and samples directions in proportion to
// luminance.
//
// Panoramas are equirectangular. Row 0 is straight up (+y). The middle column points along +x, and the column at three quarters
// of the width along +z. Blender orients panoramas in the same way around scenes imported from glTF.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "transport/sky_patches.hpp"

namespace lippmann {

/// A group of directions whose light is looked up together, with vector instructions.
struct SkyRays {
  static constexpr int kRays = 16;
  alignas(64) float x[kRays], y[kRays], z[kRays];           ///< input: unit directions
  alignas(64) float red[kRays], green[kRays], blue[kRays];  ///< output: radiance
  alignas(64) float across[kRays], down[kRays];             ///< output: panorama coordinates in [0, 1]
};

/// A group of directions that are sampled together, with vector instructions.
struct SkyDraws {
  static constexpr int kDraws = 16;
  alignas(64) float u[kDraws], v[kDraws];                      ///< input: random numbers in [0, 1)
  alignas(64) float x[kDraws], y[kDraws], z[kDraws];           ///< output: unit directions
  alignas(64) float density[kDraws];                           ///< output: density per steradian
  alignas(64) float red[kDraws], green[kDraws], blue[kDraws];  ///< output: radiance
};

class Environment {
 public:
  /// `background` must outlive this object.
  explicit Environment(const Background& background);

  /// Returns the radiance along a unit vector. Panoramas are interpolated bilinearly.
  Vec3f radiance(Vec3f direction) const;
  /// Computes the radiance along all directions of `rays`. The results are bit-identical to those of radiance(Vec3f).
  void radiance(SkyRays& rays) const;

  /// Returns the sun's share of all light, or 0 if the sky has no sun. The sun of a panorama is a small set of directions with
  /// so much light that they cast distinct shadows, such as the sun or lamps in the picture. find_sun() (sky_patches.hpp) finds
  /// these directions. Gradients have no sun. All other directions form the rest of the sky.
  float sun_share() const;

  struct Sample {
    Vec3f direction{0.0f};
    float density = 0.0f;
    Vec3f radiance{0.0f};  ///< radiance along `direction`, exact up to rounding
  };
  /// Samples a direction of the sun. Requires sun_share() > 0.
  Sample sample_sun(Vec2f u) const { return sample(sun_, u); }
  /// Samples a direction of the rest of the sky. The density in the result is 0 if the rest is dark.
  Sample sample_rest(Vec2f u) const { return sample(rest_, u); }
  /// Samples directions of the rest of the sky for all lanes of `draws`. The results are bit-identical to those of
  /// sample_rest(Vec2f).
  void sample_rest(SkyDraws& draws) const;

  struct Density {
    float value = 0.0f;   ///< density per steradian
    bool of_sun = false;  ///< true: sample_sun() samples the direction; false: sample_rest() does
  };
  /// Returns the density with which sample_sun() or sample_rest() samples the direction of ray i. The radiance of `rays` must
  /// have been looked up before.
  Density density(const SkyRays& rays, int i) const;

  bool is_dark() const { return sun_.is_dark() && rest_.is_dark(); }
  Vec3f mean_radiance() const { return mean_radiance_; }

 private:
  Sample sample(const PatchChoice& patches, Vec2f u) const;

  const Background& background_;
  Background gradient_;  ///< the background's gradient, clamped by in_light_range()
  float rotation_;       ///< rotation of the panorama in radians, in [-pi, pi]
  SkyPatches patches_;   ///< patches of the panorama, or of a grid that replaces the gradient
  PatchChoice sun_, rest_;
  Vec3f mean_radiance_{0.0f};
};

}  // namespace lippmann
