// Chooses a light of a scene for a point, and computes the probability of the choice.
//
// Near lights have inverse-square falloff. Far lights are all others: the sky, suns, and lamps without falloff. The choice has
// three steps:
// 1. Near or far, by the irradiance of each kind at the point.
// 2. A group of lights, by power.
// 3. A light of the group: by power in small groups, otherwise by a tree for the given point (light_tree.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "shading/light_tree.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// Minimum probabilities of near and of far lights, because the estimated irradiance ignores shadows.
inline constexpr float kLeastShareOfKind = 1.0f / 8.0f;

inline float finite_power(float power) { return power > 0.0f ? std::min(power, std::numeric_limits<float>::max()) : 0.0f; }

struct LightGroup {
  /// near: the flux of a near light, or 0 for a far light. far: the irradiance that a far light gives a surface facing it, or 0
  /// for a near light.
  std::vector<float> near, far;
  std::vector<TreeLight> lights;  ///< the near lights, described as the light tree needs them
  float irradiance = 0.0f;
  std::size_t most_by_power = 0;  ///< groups with more near lights than this are sampled by a tree instead of by power
};

float sum_of_powers(std::span<const TreeLight> lights);

class LightChoice {
 public:
  /// The first three parts are groups of lights. The sky is divided into its sun and the rest.
  enum Part : std::size_t { kPoints, kRounds, kTriangles, kSun, kSky };
  static constexpr std::size_t kGroups = 3;

  /// sun: irradiance of the sky's sun. sky: irradiance of the rest of the sky.
  LightChoice(std::array<LightGroup, kGroups> groups, float sun, float sky);

  struct Chosen {
    Part part;
    std::size_t light;
    float chance;
  };
  /// Chooses a light by `pick` in [0, 1). Returns nothing if no light reaches the point.
  std::optional<Chosen> choose(const LightReceiver& at, float pick) const;

  /// The probability that choose() returns the given light.
  float chance_of(Part group, std::size_t light, const LightReceiver& at) const;
  float chance_of_sun(const LightReceiver& at) const;
  float chance_of_sky(const LightReceiver& at) const;

  /// Returns whether more than about a quarter of the points choose the sky. Then it pays to sample sky directions for a whole
  /// packet at once.
  bool asks_sky_often() const { return (near_.empty() ? 1.0f : 0.5f) * far_.of_sky > 0.25f; }
  /// Returns whether choose() returns kSky for this `pick`.
  bool picks_sky(const LightReceiver& at, float pick) const { return pick >= 1.0f - chance_of_sky(at); }

  /// Returns whether there are both near and far lights. Otherwise near_share() is constant.
  bool has_both_kinds() const { return !near_.empty() && !far_.empty(); }
  float near_share(const LightReceiver& at) const;

  const LightTree& tree(Part group) const { return trees_[group].tree; }
  bool draws_by_tree(Part group) const { return near_.probability(trees_[group].entry) > 0.0f; }

 private:
  /// The choice among all near lights, or among all far lights. Each group has one entry per light, followed by one entry for
  /// its tree. In each group, either the lights or the tree have probability 0. The entry of the sun precedes the triangles,
  /// and the entry of the sky is the last.
  struct Kind {
    DiscreteDistribution chances;
    float of_sun = 0.0f, of_sky = 0.0f;

    bool empty() const { return chances.empty(); }
    float probability(std::size_t entry) const { return empty() ? 0.0f : chances.probability(entry); }
  };
  struct Tree {
    LightTree tree;
    std::size_t entry = 0, first = 0;
    float irradiance = 0.0f;
  };

  Kind kind_of(std::span<const float> powers) const;
  std::size_t sun() const { return trees_[kRounds].entry + 1; }
  std::optional<Chosen> choose_of(const Kind& kind, const LightReceiver& at, float pick) const;

  std::array<Tree, kGroups> trees_;
  Kind near_, far_;
  float far_irradiance_ = 0.0f;  ///< mean irradiance of far lights over all orientations of a surface
};

}  // namespace lippmann
