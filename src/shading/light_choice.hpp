// Chooses a light of a scene for a point, and computes the probability of the choice. light_table.hpp evaluates the lights.
//
// Lights with inverse-square falloff are near lights; all others (the sky, suns, lamps without falloff) are far lights. The
// first choice, near or far, uses the irradiance of each kind at the point, so it does not depend on the scene's size. Then a
// group is chosen by power, and a light within the group: by power if the group is small, otherwise by a tree for the given
// point (light_tree.hpp).
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

/// Minimum probability of each kind if the scene has near and far lights, because the irradiance estimate ignores shadows.
inline constexpr float kLeastShareOfKind = 1.0f / 8.0f;

/// Clamps powers to the largest float, and to 0 if they are not positive.
inline float finite_power(float power) { return power > 0.0f ? std::min(power, std::numeric_limits<float>::max()) : 0.0f; }

/// Lights of one type. All vectors have one element per light.
struct LightGroup {
  std::vector<float> near,
      far;  ///< flux of near lights and irradiance of far lights across their direction; 0 for lights of the other kind
  std::vector<TreeLight> lights;  ///< the near lights, in the tree's form
  float irradiance = 0.0f;        ///< irradiance of `lights` at distance 1
  std::size_t most_by_power = 0;  ///< largest number of near lights that are chosen by power; more use a tree
};

/// Returns the sum of the lights' powers.
float sum_of_powers(std::span<const TreeLight> lights);

class LightChoice {
 public:
  /// Point lamps, lamps with a size, and triangles are groups. The sky's sun and the rest of the sky are one light each.
  enum Part : std::size_t { kPoints, kRounds, kTriangles, kSun, kSky };
  static constexpr std::size_t kGroups = 3;

  /// sun, sky: irradiances.
  LightChoice(std::array<LightGroup, kGroups> groups, float sun, float sky);

  struct Chosen {
    Part part;
    std::size_t light;  ///< index within the group
    float chance;
  };
  /// Chooses a light. Returns nothing if no light reaches the point.
  std::optional<Chosen> choose(const LightReceiver& at, float pick) const;

  /// Return the probability that choose() returns a light of a group, the sky's sun, or the rest of the sky.
  float chance_of(Part group, std::size_t light, const LightReceiver& at) const;
  float chance_of_sun(const LightReceiver& at) const;
  float chance_of_sky(const LightReceiver& at) const;

  /// Returns whether the sky is chosen so often that sampling sky directions for all lanes of a packet in advance pays off.
  bool asks_sky_often() const { return (near_.empty() ? 1.0f : 0.5f) * far_.of_sky > 0.25f; }
  /// Returns whether choose() returns the sky (without its sun) for this `pick`.
  bool picks_sky(const LightReceiver& at, float pick) const { return pick >= 1.0f - chance_of_sky(at); }

  /// Returns whether there are both near and far lights. Otherwise near_share() is constant.
  bool has_both_kinds() const { return !near_.empty() && !far_.empty(); }
  /// Returns the probability that choose() returns a near light.
  float near_share(const LightReceiver& at) const;

  /// Returns the tree of a group's near lights. It exists even if the lights are chosen by power.
  const LightTree& tree(Part group) const { return trees_[group].tree; }
  bool draws_by_tree(Part group) const { return near_.probability(trees_[group].entry) > 0.0f; }

 private:
  /// The lights of one kind, near or far. Both kinds list the same entries: for each group, its lights and then its tree; the
  /// sun precedes the triangles, and the sky comes last. Lights of the other kind have probability 0. If a group uses its tree,
  /// its lights have probability 0 and the tree has their power; otherwise the tree has probability 0.
  struct Kind {
    DiscreteDistribution chances;
    float of_sun = 0.0f, of_sky = 0.0f;

    bool empty() const { return chances.empty(); }
    float probability(std::size_t entry) const { return empty() ? 0.0f : chances.probability(entry); }
  };
  struct Tree {
    LightTree tree;
    std::size_t entry = 0, first = 0;  ///< index of the tree's entry and of the group's first light
    float irradiance = 0.0f;           ///< irradiance of the tree's lights at distance 1
  };

  Kind kind_of(std::span<const float> powers) const;
  std::size_t sun() const { return trees_[kRounds].entry + 1; }
  std::optional<Chosen> choose_of(const Kind& kind, const LightReceiver& at, float pick) const;

  std::array<Tree, kGroups> trees_;
  Kind near_, far_;
  float far_irradiance_ = 0.0f;  ///< irradiance of far lights on a randomly oriented surface
};

}  // namespace lippmann
