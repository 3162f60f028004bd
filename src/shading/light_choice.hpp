// Which light of a scene is drawn for a point, and how probably; light_table.hpp has what the lights are.
//
// Lights that fall off with the squared distance are near lights, all others (the sky, suns, lamps without falloff) are far
// ones. Near or far is drawn by the irradiance that each kind sends to the point, so the scene's size does not matter. Of one
// kind, a group is drawn by its power, and of the group a light: of few lights by their power, too; of many by a tree, for the
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

/// Where a scene has near and far lights, each kind is drawn with at least this probability: the estimate ignores shadows.
inline constexpr float kLeastShareOfKind = 1.0f / 8.0f;

/// The largest float for powers beyond it, and 0 for what is not a positive number.
inline float finite_power(float power) { return power > 0.0f ? std::min(power, std::numeric_limits<float>::max()) : 0.0f; }

/// Lights that are drawn alike. All vectors have one element per light.
struct LightGroup {
  std::vector<float> near, far;   ///< flux of near lights, irradiance of far ones across their direction; 0 for the other kind
  std::vector<TreeLight> lights;  ///< the near ones as a tree knows them
  float irradiance = 0.0f;        ///< of `lights`, at distance 1
  std::size_t most_by_power = 0;  ///< up to this many near lights are drawn by their power; more are drawn by a tree
};

/// The sum of the lights' powers.
float sum_of_powers(std::span<const TreeLight> lights);

class LightChoice {
 public:
  /// Points, lamps that have a size, and triangles are groups. The sky's sun and the rest of the sky are one light each.
  enum Part : std::size_t { kPoints, kRounds, kTriangles, kSun, kSky };
  static constexpr std::size_t kGroups = 3;

  /// sun, sky: irradiances.
  LightChoice(std::array<LightGroup, kGroups> groups, float sun, float sky);

  struct Chosen {
    Part part;
    std::size_t light;  ///< of the group
    float chance;
  };
  /// Draws a light. None where none reaches the point.
  std::optional<Chosen> choose(const LightReceiver& at, float pick) const;

  /// The probability that choose() draws a light of a group, or a sample of the sky's sun, or of the rest of the sky.
  float chance_of(Part group, std::size_t light, const LightReceiver& at) const;
  float chance_of_sun(const LightReceiver& at) const;
  float chance_of_sky(const LightReceiver& at) const;

  /// Whether drawing sky directions for all lanes of a packet at once pays off, before it is known which lanes sample the sky.
  bool asks_sky_often() const { return (near_.empty() ? 1.0f : 0.5f) * far_.of_sky > 0.25f; }
  /// Whether choose() draws the sky, without its sun, for this `pick`.
  bool picks_sky(const LightReceiver& at, float pick) const { return pick >= 1.0f - chance_of_sky(at); }

  /// Whether there are near and far lights: else near_share() is the same everywhere.
  bool has_both_kinds() const { return !near_.empty() && !far_.empty(); }
  /// The chance of choose() to draw a near light.
  float near_share(const LightReceiver& at) const;

  /// The near lights of a group. It is there even if the group's lights are drawn by their power.
  const LightTree& tree(Part group) const { return trees_[group].tree; }
  bool draws_by_tree(Part group) const { return near_.probability(trees_[group].entry) > 0.0f; }

 private:
  /// The lights of one kind. Near and far ones have the same entries: the lights of each group and then its tree, whether it is
  /// used or not, with the sun before the triangles and the sky at the end. Lights of the other kind have chance 0, and where a
  /// group is drawn by its tree, its lights have chance 0 and the tree has their power.
  struct Kind {
    DiscreteDistribution chances;
    float of_sun = 0.0f, of_sky = 0.0f;

    bool empty() const { return chances.empty(); }
    float probability(std::size_t entry) const { return empty() ? 0.0f : chances.probability(entry); }
  };
  struct Tree {
    LightTree tree;
    std::size_t entry = 0, first = 0;  ///< its own entry, and that of the group's first light
    float irradiance = 0.0f;           ///< of its lights, at distance 1
  };

  Kind kind_of(std::span<const float> powers) const;
  std::size_t sun() const { return trees_[kRounds].entry + 1; }
  std::optional<Chosen> choose_of(const Kind& kind, const LightReceiver& at, float pick) const;

  std::array<Tree, kGroups> trees_;
  Kind near_, far_;
  float far_irradiance_ = 0.0f;  ///< of far lights, on a surface turned any way
};

}  // namespace lippmann
