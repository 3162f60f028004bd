#include "stage/main_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lippmann {
namespace {

/// The scene is cut only if all gaps are at least this many times as wide as the main part's diagonal.
constexpr float kFarAway = 20.0f;
/// Gaps narrower than this fraction of the scene's longest side are ignored, because they are normal in a scattered scene.
constexpr float kWideGap = 0.2f;
/// A triangle is a sliver if its longest side is at least this many times its shortest side.
constexpr float kSliver = 1000.0f;
constexpr int kMostCuts = 64;
constexpr std::size_t kBins = 512;  ///< The gap search divides each axis into this many bins.

struct Gap {
  int axis = 0;
  float middle = 0.0f, width = 0.0f;
};

Bounds3f bounds_of(const std::vector<ScenePiece>& pieces) {
  Bounds3f all;
  for (const ScenePiece& piece : pieces) all.add(piece.bounds);
  return all;
}

Gap widest_gap(const std::vector<ScenePiece>& pieces, const Bounds3f& all, int axis) {
  const float size = all.size()[axis], bin = size / static_cast<float>(kBins);
  if (!(bin > 0.0f) || !std::isfinite(size)) return {};
  const auto bin_of = [&](float at) {
    return std::min(static_cast<std::size_t>(std::max((at - all.lower[axis]) / bin, 0.0f)), kBins - 1);
  };
  // Number of pieces that begin in a bin, minus the pieces that end in the previous bin.
  std::array<int, kBins + 1> begins{};
  for (const ScenePiece& piece : pieces) {
    ++begins[bin_of(piece.bounds.lower[axis])];
    --begins[bin_of(piece.bounds.upper[axis]) + 1];
  }
  Gap widest{axis, 0.0f, 0.0f};
  int open = 0;
  std::size_t run = 0;
  for (std::size_t i = 0; i < kBins; ++i) {
    open += begins[i];
    run = open == 0 ? run + 1 : 0;
    if (const float width = static_cast<float>(run) * bin; width > widest.width)
      widest = {axis, all.lower[axis] + (static_cast<float>(i + 1) * bin - 0.5f * width), width};
  }
  return widest;
}

Gap widest_gap(const std::vector<ScenePiece>& pieces, const Bounds3f& all) {
  Gap widest;
  for (int axis = 0; axis < 3; ++axis)
    if (const Gap gap = widest_gap(pieces, all, axis); gap.width > widest.width) widest = gap;
  return widest;
}

/// Returns the pieces on the side of the gap with more surface area, or with more pieces if areas are equal.
std::vector<ScenePiece> heavier_side(const std::vector<ScenePiece>& pieces, const Gap& gap) {
  std::array<std::vector<ScenePiece>, 2> sides;
  std::array<double, 2> areas{};
  for (const ScenePiece& piece : pieces) {
    const std::size_t side = piece.bounds.lower[gap.axis] > gap.middle ? 1 : 0;
    sides[side].push_back(piece);
    areas[side] += static_cast<double>(piece.area);
  }
  const bool upper = areas[1] != areas[0] ? areas[1] > areas[0] : sides[1].size() > sides[0].size();
  return std::move(sides[upper ? 1 : 0]);
}

}  // namespace

ScenePiece piece_of_triangle(Vec3f a, Vec3f b, Vec3f c) {
  ScenePiece piece;
  for (const Vec3f& corner : {a, b, c}) piece.bounds.add(corner);
  const float sides[] = {glm::length(b - a), glm::length(c - b), glm::length(a - c)};
  const auto [shortest, longest] = std::minmax_element(std::begin(sides), std::end(sides));
  piece.area = 0.5f * glm::length(glm::cross(b - a, c - a));
  piece.is_sliver = *longest > kSliver * *shortest;
  return piece;
}

std::optional<Bounds3f> find_main_part(std::vector<ScenePiece> pieces) {
  std::erase_if(pieces, [](const ScenePiece& piece) {
    const Vec3f size = piece.bounds.empty() ? Vec3f(kInfinity) : piece.bounds.size();
    return !std::isfinite(size.x + size.y + size.z);
  });
  const Bounds3f everything = bounds_of(pieces);
  std::erase_if(pieces, [](const ScenePiece& piece) { return piece.is_sliver; });
  std::optional<Bounds3f> main;
  if (const Bounds3f rest = bounds_of(pieces); !rest.empty())
    if (const float size = glm::length(rest.size()); size > 0.0f && glm::length(everything.size()) > kFarAway * size)
      main = Bounds3f{rest.lower - Vec3f(size), rest.upper + Vec3f(size)};
  float narrowest = kInfinity;
  for (int cut = 0; cut < kMostCuts && pieces.size() > 1; ++cut) {
    const Bounds3f all = bounds_of(pieces);
    const Gap gap = widest_gap(pieces, all);
    const Vec3f sides = all.size();
    if (!(gap.width > kWideGap * std::max({sides.x, sides.y, sides.z}))) break;
    narrowest = std::min(narrowest, gap.width);
    pieces = heavier_side(pieces, gap);
    const Bounds3f rest = bounds_of(pieces);
    const float size = glm::length(rest.size());
    if (!(size > 0.0f) || kFarAway * size > narrowest) continue;
    main = Bounds3f{rest.lower - Vec3f(size), rest.upper + Vec3f(size)};
    narrowest = kInfinity;
  }
  return main;
}

}  // namespace lippmann
