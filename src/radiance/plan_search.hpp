// How the frames of a history are made: found in its first frame, by trying setups of the cache on some patches.
#pragma once

#include "radiance/cached_light.hpp"
#include "radiance/frame_cache.hpp"
#include "radiance/gather_error.hpp"

namespace lippmann {

/// Outlived by what it was made with.
class PlanSearch {
 public:
  /// cache: that of a history's first frame; nothing is in it yet.
  PlanSearch(const Shot& shot, const TraceParams& params, const CachedLightGoal& goal, const Workers& workers,
             FrameCache& cache);

  /// The plan for all frames, and the cache set up for it; none where paths are cheaper.
  std::optional<GatherPlan> find();

  /// All that was traced, but for updates of the cache.
  RayCounts counts() const;

  /// What frames may err by.
  const FrameError& goal() const { return measure_.goal(); }

  /// The squared error of pixels that are traced by TraceParams::spp paths.
  float error_of_paths() const { return measure_.of_paths(); }

 private:
  struct Candidate {
    CacheSetup setup;
    GatherPlan plan;
  };
  SetupOutcome try_setup(const SetupSearch& search);
  SetupOutcome try_within(double seconds);
  bool is_good_elsewhere(int looks);
  FrameError found_elsewhere();
  void keep_mixed(const CacheSetup& setup);
  bool may_gain(const SetupOutcome& outcome) const;
  double rays_until_good(const SetupOutcome& outcome) const;
  double seconds_for_pixels(double seconds) const;
  std::optional<Candidate> chosen(const SetupSearch& search) const;

  Shot shot_;
  const TraceParams& params_;
  CachedLightGoal goal_;
  const Workers workers_;
  FrameCache& cache_;
  GatherMeasure measure_;
  RayCounts confirming_;            ///< on other patches
  int looks_ = 0;                   ///< at them
  std::optional<GatherPlan> plan_;  ///< the plan for the setup that was tried last
  std::optional<GatherPlan> good_;  ///< the plan for the good setup that was tried last
  std::optional<Candidate> mixed_;  ///< the one that takes the fewest rays among those that are good with paths
};

}  // namespace lippmann
