#pragma once

#include <array>
#include <utility>

#include "device/lanes.hpp"
#include "trace/path_ray.hpp"
#include "transport/environment.hpp"
#include "transport/sampler.hpp"

namespace lippmann {

class PathNumbers {
 public:
  /// Computes the numbers of the active lanes. `rays` has one element per lane. with_last: also compute the last pair
  /// (kCoveragePair).
  void draw(const LaneMask& lanes, const PathRay* rays, bool with_last) {
    PathPairs paths;
    for (int i = 0; i < kLanes; ++i) {
      const bool hit = lanes.lane[i] != 0;
      paths.seed[i] = hit ? rays[i].seed : 0u;
      paths.index[i] = hit ? rays[i].index : 0u;
      paths.first[i] = hit ? kPairsPerEvent * rays[i].events : 0u;
    }
    has_sky_draws_ = false;
    for (std::uint32_t p = 0; p < (with_last ? kPairsPerEvent : kPairsPerEvent - 1); ++p)
      sample_pairs(paths, p, pairs_[p].x.lane, pairs_[p].y.lane);
  }

  struct LanePairs {
    Lanes x, y;
  };
  const LanePairs& pairs(std::uint32_t pair) const { return pairs_[pair]; }
  Vec2f pair(int i, std::uint32_t pair) const { return {pairs_[pair].x[i], pairs_[pair].y[i]}; }

  /// Returns one sampled direction to the sky per lane.
  const SkyDraws& sky_draws(const Environment& environment) {
    if (!std::exchange(has_sky_draws_, true)) {
      LIPPMANN_FOR_LANES(i) sky_draws_.u[i] = pairs_[kOnLightPair].x[i], sky_draws_.v[i] = pairs_[kOnLightPair].y[i];
      environment.sample_rest(sky_draws_);
    }
    return sky_draws_;
  }

 private:
  std::array<LanePairs, kPairsPerEvent> pairs_;
  SkyDraws sky_draws_;
  bool has_sky_draws_ = false;
};

}  // namespace lippmann
