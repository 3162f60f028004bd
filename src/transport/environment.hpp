// Light from infinitely far away: a panorama or a gradient.
//
// Panoramas are equirectangular. Row 0 is straight up (+y). The middle column points along +x, and the column at three quarters
// of the width along +z.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "transport/sky_patches.hpp"

namespace lippmann {

/// Directions whose light is looked up together, with vector instructions.
struct SkyRays {
  static constexpr int kRays = 16;
  alignas(64) float x[kRays], y[kRays], z[kRays];
  alignas(64) float red[kRays], green[kRays], blue[kRays];
  alignas(64) float across[kRays], down[kRays];
};

/// Directions that are sampled together, with vector instructions.
struct SkyDraws {
  static constexpr int kDraws = 16;
  alignas(64) float u[kDraws], v[kDraws];
  alignas(64) float x[kDraws], y[kDraws], z[kDraws];
  alignas(64) float density[kDraws];  ///< output: probability density per steradian
  alignas(64) float red[kDraws], green[kDraws], blue[kDraws];
};

class Environment {
 public:
  /// `background` must outlive this object.
  explicit Environment(const Background& background);

  Vec3f radiance(Vec3f direction) const;
  void radiance(SkyRays& rays) const;

  /// Returns the sun's fraction of all light, or 0 without a sun. The sun is a small bright set of directions that casts
  /// distinct shadows (see find_sun() in sky_patches.hpp). Gradients have no sun.
  float sun_share() const;

  struct Sample {
    Vec3f direction{0.0f};
    float density = 0.0f;
    Vec3f radiance{0.0f};
  };
  Sample sample_sun(Vec2f u) const { return sample(sun_, u); }
  /// Samples a direction outside the sun. The density in the result is 0 if all such directions are dark.
  Sample sample_rest(Vec2f u) const { return sample(rest_, u); }
  void sample_rest(SkyDraws& draws) const;

  struct Density {
    float value = 0.0f;
    bool of_sun = false;
  };
  /// Returns the density with which sample_sun() or sample_rest() samples the direction of ray i. `rays` must hold the radiance
  /// of this ray.
  Density density(const SkyRays& rays, int i) const;

  bool is_dark() const { return sun_.is_dark() && rest_.is_dark(); }
  Vec3f mean_radiance() const { return mean_radiance_; }

 private:
  Sample sample(const PatchChoice& patches, Vec2f u) const;

  const Background& background_;
  Background gradient_;
  float rotation_;
  SkyPatches patches_;
  PatchChoice sun_, rest_;
  Vec3f mean_radiance_{0.0f};
};

}  // namespace lippmann
