#include "shading/light_choice.hpp"

#include <utility>

namespace lippmann {
namespace {

constexpr float kBelowOne = 1.0f - 0x1p-24f;

bool needs_tree(const LightGroup& group) {
  const auto in_tree =
      std::count_if(group.lights.begin(), group.lights.end(), [](const TreeLight& l) { return l.power > 0.0f; });
  return static_cast<std::size_t>(in_tree) > group.most_by_power;
}

}  // namespace

float sum_of_powers(std::span<const TreeLight> lights) {
  double sum = 0.0;
  for (const TreeLight& l : lights) sum += static_cast<double>(l.power);
  return static_cast<float>(sum);
}

LightChoice::LightChoice(std::array<LightGroup, kGroups> groups, float sun, float sky) {
  std::vector<float> near, far;
  const auto add = [&](float near_power, float far_power) { near.push_back(near_power), far.push_back(far_power); };
  for (std::size_t g = 0; g < kGroups; ++g) {
    if (g == kTriangles) add(0.0f, sun);
    LightGroup& group = groups[g];
    const std::size_t first = near.size();
    double of_tree = 0.0;
    if (needs_tree(group))
      for (std::size_t l = 0; l < group.lights.size(); ++l)
        if (group.lights[l].power > 0.0f) of_tree += static_cast<double>(std::exchange(group.near[l], 0.0f));
    near.insert(near.end(), group.near.begin(), group.near.end());
    far.insert(far.end(), group.far.begin(), group.far.end());
    trees_[g] = {LightTree(group.lights), near.size(), first, group.irradiance};
    add(static_cast<float>(of_tree), 0.0f);
  }
  add(0.0f, sky);
  near_ = kind_of(near), far_ = kind_of(far);
  // The mean irradiance over all orientations is a quarter of the irradiance of a surface that faces the light.
  far_irradiance_ = 0.25f * static_cast<float>(far_.chances.total());
}

LightChoice::Kind LightChoice::kind_of(std::span<const float> powers) const {
  Kind kind{DiscreteDistribution(powers)};
  if (kind.empty()) return kind;
  kind.of_sun = kind.chances.probability_before(sun() + 1) - kind.chances.probability_before(sun());
  kind.of_sky = 1.0f - kind.chances.probability_before(powers.size() - 1);
  return kind;
}

float LightChoice::near_share(const LightReceiver& at) const {
  if (near_.empty() || far_.empty()) return near_.empty() ? 0.0f : 1.0f;
  if (at.near_share >= 0.0f) return at.near_share;
  float irradiance = 0.0f;
  for (const Tree& group : trees_)
    if (!group.tree.empty()) irradiance += group.irradiance * group.tree.importance(at);
  const float share = 1.0f - 1.0f / (1.0f + irradiance / far_irradiance_);
  return std::min(1.0f - kLeastShareOfKind, std::max(kLeastShareOfKind, share));
}

float LightChoice::chance_of_sky(const LightReceiver& at) const {
  const float near = near_share(at);
  return near * near_.of_sky + (1.0f - near) * far_.of_sky;
}

float LightChoice::chance_of_sun(const LightReceiver& at) const {
  const float near = near_share(at);
  return near * near_.of_sun + (1.0f - near) * far_.of_sun;
}

/// A light is chosen either by its own entry in near_ or far_, or through the tree of its group, never by both ways.
float LightChoice::chance_of(Part group, std::size_t light, const LightReceiver& at) const {
  const Tree& by_tree = trees_[group];
  const float near = near_share(at);
  const float own = near * near_.probability(by_tree.first + light) + (1.0f - near) * far_.probability(by_tree.first + light);
  if (own > 0.0f || !draws_by_tree(group)) return own;
  return near * near_.probability(by_tree.entry) * by_tree.tree.probability(static_cast<std::uint32_t>(light), at);
}

/// `pick` first chooses between near and far lights. The position of `pick` within the chosen interval then chooses a light.
std::optional<LightChoice::Chosen> LightChoice::choose(const LightReceiver& at, float pick) const {
  if (near_.empty() && far_.empty()) return std::nullopt;
  const float near = near_share(at);
  const bool is_near = pick < near || far_.empty();
  const float of_kind = is_near ? near : 1.0f - near, within = (is_near ? pick : pick - near) / of_kind;
  std::optional<Chosen> chosen = choose_of(is_near ? near_ : far_, at, std::clamp(within, 0.0f, kBelowOne));
  if (chosen) chosen->chance = of_kind * chosen->chance;
  return chosen;
}

/// The entries of trees are tested first, because a search in the list of all entries is slow for many lights.
std::optional<LightChoice::Chosen> LightChoice::choose_of(const Kind& kind, const LightReceiver& at, float pick) const {
  for (std::size_t g = 0; g < kGroups; ++g) {
    const Tree& group = trees_[g];
    if (group.tree.empty()) continue;
    const float begin = kind.chances.probability_before(group.entry), end = kind.chances.probability_before(group.entry + 1);
    if (!(begin <= pick && pick < end)) continue;
    const float chance = end - begin;
    const std::optional<LightTree::Choice> choice = group.tree.choose(at, std::min((pick - begin) / chance, kBelowOne));
    if (!choice) return std::nullopt;
    return Chosen{static_cast<Part>(g), choice->light, chance * choice->probability};
  }
  float rest = 0.0f;
  const std::size_t entry = kind.chances.sample(pick, rest);
  const float chance = kind.chances.probability(entry);
  if (entry == sun()) return Chosen{kSun, 0, chance};
  for (std::size_t g = 0; g < kGroups; ++g)
    if (entry < trees_[g].entry) return Chosen{static_cast<Part>(g), entry - trees_[g].first, chance};
  return Chosen{kSky, 0, chance};
}

}  // namespace lippmann
