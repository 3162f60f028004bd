#include "reuse/missed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace lippmann {
namespace {

/// Neighbours belong to different surfaces if their depths differ by more than kSameLayer (1 mm + |depth|).
constexpr float kSameLayer = 0.1f;

/// The nearest point to the viewer among the points of both source frames that land on a pixel.
struct Seen {
  std::uint32_t pixel;
  float z;  ///< -infinity for background
  const SplatSource* by;

  std::uint32_t object() const { return by->image.points.object[SplatBuffer::source(by->landed.keys[pixel])]; }
};

std::optional<Seen> seen_at(const SplatPair& pair, std::uint32_t pixel) {
  const std::uint64_t previous = pair.previous.landed.keys[pixel], following = pair.following.landed.keys[pixel];
  if ((previous | following) == 0) return std::nullopt;
  const bool following_nearer = following >> 32 > previous >> 32;
  return Seen{pixel, SplatBuffer::depth(following_nearer ? following : previous),
              following_nearer ? &pair.following : &pair.previous};
}

struct Neighbour {
  Seen seen;
  float distance_px;
};

using Surroundings = std::array<std::optional<Neighbour>, 4>;

Surroundings look_around(const SplatPair& pair, const ViewSteps& steps, std::uint32_t pixel) {
  Surroundings around;
  for (std::size_t d = 0; d < around.size(); ++d) {
    const StepDirection direction = kStepDirections[d];
    const bool sideways = direction == StepDirection::kLeft || direction == StepDirection::kRight;
    ViewWalk walk = steps.walk(pixel, direction);
    for (int count = 1; sideways || count <= kFillReach; ++count) {
      const auto at = walk.next();
      if (!at) break;
      const auto seen = seen_at(pair, *at);
      if (!seen) continue;
      around[d] = Neighbour{*seen, steps.length_px(direction) * static_cast<float>(count)};
      break;
    }
  }
  return around;
}

bool is_covered(const SplatPair& pair, const Splatter& splatter, std::uint32_t pixel, const Surroundings& around) {
  const auto &left = around[0], &right = around[1];
  if (!left && !right) return false;
  const Seen& behind = !right || (left && left->seen.z < right->seen.z) ? left->seen : right->seen;
  const std::uint32_t object = behind.object();
  if (object == kNoObject) return true;
  return splatter.landing(pixel, behind.z, object, pair.back_to_previous).has_value() ||
         splatter.landing(pixel, behind.z, object, pair.back_to_following).has_value();
}

Vec3f color_at(const Image& film, std::size_t pixel) {
  const float* p = film.data.data() + 3 * pixel;
  return {p[0], p[1], p[2]};
}

Vec3f interpolated(const SplatPair& pair, std::uint32_t pixel, const Surroundings& around, const Image& film) {
  float farthest = kInfinity;
  for (const auto& neighbour : around)
    if (neighbour) farthest = std::min(farthest, neighbour->seen.z);
  if (farthest == kInfinity)
    return 0.5f * (color_at(pair.previous.image.film, pixel) + color_at(pair.following.image.film, pixel));
  // If the farthest neighbour is background (-infinity), only background is in the same layer.
  const float layer_end = farthest == -kInfinity ? farthest : farthest + kSameLayer * (1.0f + std::abs(farthest));
  Vec3f sum(0.0f);
  float weights = 0.0f;
  for (const auto& neighbour : around) {
    if (!neighbour || neighbour->seen.z > layer_end) continue;
    const float weight = 1.0f / neighbour->distance_px;
    sum += weight * color_at(film, neighbour->seen.pixel);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

MissedCauses resolve_missed(const SplatPair& pair, const Splatter& splatter, const ViewSteps& steps,
                            std::span<const std::uint32_t> missed, const ThreadPool& pool, Image* film) {
  constexpr std::size_t kPiece = 256;
  std::vector<std::uint64_t> covered((missed.size() + kPiece - 1) / kPiece);
  pool.for_each(covered.size(), [&](std::size_t piece) {
    for (const std::uint32_t pixel : missed.subspan(piece * kPiece, std::min(kPiece, missed.size() - piece * kPiece))) {
      const Surroundings around = look_around(pair, steps, pixel);
      covered[piece] += is_covered(pair, splatter, pixel, around) ? 1 : 0;
      if (!film) continue;
      const Vec3f color = interpolated(pair, pixel, around, *film);
      for (int c = 0; c < 3; ++c) film->data[3 * static_cast<std::size_t>(pixel) + static_cast<std::size_t>(c)] = color[c];
    }
  });
  const std::uint64_t newly_visible = std::accumulate(covered.begin(), covered.end(), std::uint64_t{0});
  return {newly_visible, missed.size() - newly_visible};
}

}  // namespace lippmann
