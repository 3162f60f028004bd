// A panorama's light between its texels: which part of it is a sun, and directions drawn exactly by the light that is looked up
// bilinearly.
//
// A patch lies between the centres of four neighbouring texels, where looked-up light is bilinear. There are as many columns of
// patches as of texels (the last one leads round to the first texels) and one row more: the first and the last row are half as
// high and lie between the poles and the outermost texels. Rows count from straight up.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "lippmann/core/math.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// The luminance of a grid of texels over the sphere, seen as patches.
class SkyPatches {
 public:
  SkyPatches(int width, int height);  ///< texels; all of them dark

  int width() const { return width_; }
  int height() const { return height_; }
  float texel_solid_angle(int y) const;
  float luminance(int x, int y) const { return luminance_[index(x, y)]; }
  void set(int x, int y, float luminance) { luminance_[index(x, y)] = luminance; }

  /// Somewhere on the sphere.
  struct Place {
    int x = 0, y = 0;    ///< the patch's column and row
    Vec2f within{0.0f};  ///< in [0, 1]: across in azimuth, down in the cosine of the polar angle, which is even in solid angle
  };
  /// across, down: shares of the turn and of the polar angle, in [0, 1); `cosine`: the polar angle's.
  Place at(Vec2f across_down, float cosine) const;

  int rows() const { return height_ + 1; }
  std::size_t patch(int x, int y) const { return index(x, y); }
  float patch_solid_angle(int y) const {
    return (cosine_above(y) - cosine_above(y + 1)) * 2.0f * kPi / static_cast<float>(width_);
  }
  /// Cosine of the polar angle at the top of a row of patches.
  float cosine_above(int y) const { return cosines_[static_cast<std::size_t>(y)]; }
  /// Luminance at the patch's corners: upper left, upper right, lower left, lower right.
  std::array<float, 4> corners(int x, int y) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<float> luminance_;
  std::vector<float> cosines_;
};

/// By SkyPatches::patch.
using PatchMask = std::vector<bool>;

/// The patches of a sun: those that touch texels of at least 50 times the mean luminance, a level that is doubled until they
/// fit into 0.02 steradian; no patches (an empty mask) where these texels have less than a tenth of all light. So neither
/// panoramas with a sun that clouds veil nor those with large windows have one: their shadows are soft.
PatchMask find_sun(const SkyPatches& sky);

/// Draws places of some of a sky's patches by their luminance.
class PatchChoice {
 public:
  PatchChoice() = default;  ///< has no patches
  PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of);

  bool is_dark() const { return rows_.empty(); }
  /// Luminance over solid angle.
  double total() const { return rows_.total(); }

  struct Chosen {
    float across, cosine;  ///< share of the turn; the polar angle's cosine
    float density;         ///< per steradian
  };
  /// Not where is_dark(). `sky` is that which it was made for.
  Chosen sample(const SkyPatches& sky, Vec2f u) const;
  /// The density of sample() there, per steradian; 0 in patches that are not its own.
  float density(const SkyPatches& sky, const SkyPatches::Place& place) const;

 private:
  float density_of_patch(const SkyPatches& sky, int x, int y) const;

  DiscreteDistribution rows_;
  std::vector<DiscreteDistribution> columns_;  ///< per row
};

}  // namespace lippmann
