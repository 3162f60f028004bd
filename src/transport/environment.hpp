// Light from infinitely far away: a panorama or the gradient of a scene. Evaluates its radiance and samples directions by
// brightness.
//
// Panoramas are equirectangular: row 0 is straight up (+y), the middle column lies along +x, and the column at three quarters
// along +z. Blender shows panoramas the same way to scenes imported from glTF.
#pragma once

#include "lippmann/scene/scene.hpp"
#include "transport/sky_patches.hpp"

namespace lippmann {

/// A group of directions, whose light is looked up together with vector instructions.
struct SkyRays {
  static constexpr int kRays = 16;
  alignas(64) float x[kRays], y[kRays], z[kRays];           ///< unit vectors
  alignas(64) float red[kRays], green[kRays], blue[kRays];  ///< output: the radiance along the directions
  alignas(64) float across[kRays], down[kRays];             ///< output: the panorama coordinates, in [0, 1]
};

/// A group of directions that are sampled together with vector instructions.
struct SkyDraws {
  static constexpr int kDraws = 16;
  alignas(64) float u[kDraws], v[kDraws];                      ///< input: random numbers in [0, 1)
  alignas(64) float x[kDraws], y[kDraws], z[kDraws];           ///< output: unit directions
  alignas(64) float density[kDraws];                           ///< output: densities, per steradian
  alignas(64) float red[kDraws], green[kDraws], blue[kDraws];  ///< output: radiance along the directions
};

class Environment {
 public:
  /// `background` must outlive this object.
  explicit Environment(const Background& background);

  /// Returns the radiance along a unit vector. Panoramas are interpolated bilinearly.
  Vec3f radiance(Vec3f direction) const;
  /// Computes the radiance along all of `rays`. The results are bit-identical to single calls.
  void radiance(SkyRays& rays) const;

  /// Returns the share of all light that comes from the sun, or 0 without a sun. The sun is a small set of directions with so
  /// much of the light that they cast distinct shadows, such as a panorama's sun or lamps; find_sun() (sky_patches.hpp) finds
  /// it. Gradients have no sun. All other directions form the rest of the sky.
  float sun_share() const;

  struct Sample {
    Vec3f direction{0.0f};
    float density = 0.0f;  ///< per steradian
    Vec3f radiance{0.0f};  ///< radiance along the direction, up to rounding
  };
  /// Samples a direction of the sun. Requires sun_share() > 0.
  Sample sample_sun(Vec2f u) const { return sample(sun_, u); }
  /// Samples a direction of the rest of the sky. The density is 0 if the rest is dark.
  Sample sample_rest(Vec2f u) const { return sample(rest_, u); }
  /// Samples directions of the rest of the sky for all of `draws`. The results are bit-identical to single calls.
  void sample_rest(SkyDraws& draws) const;

  struct Density {
    float value = 0.0f;   ///< per steradian
    bool of_sun = false;  ///< whether sample_sun() draws the direction; otherwise sample_rest() does
  };
  /// Returns the density with which the direction of ray i is sampled. The radiance of `rays` must have been looked up.
  Density density(const SkyRays& rays, int i) const;

  bool is_dark() const { return sun_.is_dark() && rest_.is_dark(); }
  /// Returns the mean radiance over all directions.
  Vec3f mean_radiance() const { return mean_radiance_; }

 private:
  Sample sample(const PatchChoice& patches, Vec2f u) const;

  const Background& background_;
  Background gradient_;  ///< the background without its map, clamped by in_light_range()
  float rotation_;       ///< rotation of the panorama, within half a turn
  SkyPatches patches_;   ///< patches of the panorama, or of a grid that follows the gradient
  PatchChoice sun_, rest_;
  Vec3f mean_radiance_{0.0f};
};

}  // namespace lippmann
