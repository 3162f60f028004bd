// Light from infinitely far away: a panorama or a scene's gradient, its radiance along a direction, and directions drawn where
// it is bright.
//
// Panoramas are equirectangular, row 0 straight up (+y), the middle column along +x, the column at three quarters along +z (as
// Blender shows them to a scene that it has imported from glTF).
#pragma once

#include "lippmann/scene/scene.hpp"
#include "transport/sky_patches.hpp"

namespace lippmann {

/// Directions side by side, whose light is looked up together in a fraction of the time.
struct SkyRays {
  static constexpr int kRays = 16;
  alignas(64) float x[kRays], y[kRays], z[kRays];           ///< unit vectors
  alignas(64) float red[kRays], green[kRays], blue[kRays];  ///< receive the radiance along them,
  alignas(64) float across[kRays], down[kRays];             ///< and where that is in the panorama, in [0, 1]
};

/// Directions that are drawn side by side, in a fraction of the time.
struct SkyDraws {
  static constexpr int kDraws = 16;
  alignas(64) float u[kDraws], v[kDraws];                      ///< in [0, 1)
  alignas(64) float x[kDraws], y[kDraws], z[kDraws];           ///< receive the unit directions,
  alignas(64) float density[kDraws];                           ///< per steradian,
  alignas(64) float red[kDraws], green[kDraws], blue[kDraws];  ///< and the radiance along them
};

class Environment {
 public:
  /// `background` must outlive it.
  explicit Environment(const Background& background);

  /// Along a unit vector; panoramas bilinear.
  Vec3f radiance(Vec3f direction) const;
  /// Along all of `rays`, to the same bits.
  void radiance(SkyRays& rays) const;

  /// Few directions that hold so much of the light that they cast shadows of their own: a panorama's sun, or its lamps. Found
  /// by find_sun() (sky_patches.hpp); gradients have none. All other directions are the rest of the sky.
  /// This is the share of all light that comes from them: 0 where there is no such sun.
  float sun_share() const;

  struct Sample {
    Vec3f direction{0.0f};
    float density = 0.0f;  ///< per steradian
    Vec3f radiance{0.0f};  ///< along the direction, but for rounding
  };
  /// A direction of the sun, where sun_share() > 0.
  Sample sample_sun(Vec2f u) const { return sample(sun_, u); }
  /// One of the rest of the sky; its density is 0 where that is dark.
  Sample sample_rest(Vec2f u) const { return sample(rest_, u); }
  /// Likewise for all of `draws`, to the same bits.
  void sample_rest(SkyDraws& draws) const;

  struct Density {
    float value = 0.0f;   ///< per steradian
    bool of_sun = false;  ///< whether sample_sun() draws the direction; else sample_rest() does
  };
  /// Along ray i of those whose radiance was looked up.
  Density density(const SkyRays& rays, int i) const;

  bool is_dark() const { return sun_.is_dark() && rest_.is_dark(); }
  /// Mean over all directions.
  Vec3f mean_radiance() const { return mean_radiance_; }

 private:
  Sample sample(const PatchChoice& patches, Vec2f u) const;

  const Background& background_;
  Background gradient_;  ///< the background without its map, in the range of light
  float rotation_;       ///< the panorama's, within half a turn
  SkyPatches patches_;   ///< patches of the panorama, or of a grid that follows the gradient
  PatchChoice sun_, rest_;
  Vec3f mean_radiance_{0.0f};
};

}  // namespace lippmann
