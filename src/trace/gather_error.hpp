// How good frames of cached light are, measured on some of their pixels against paths, and how many samples it takes to be as
// good as is asked for. Private to src/trace.
//
// Held-out patches, spread over the frame, are traced twice by paths, with random numbers of their own. What a picture differs
// by from the one, times what it differs by from the other, is its squared error on average: what both sets of paths err by has
// nothing to do with each other. Of single pixels, and of the means of patches, which are what lens arrays and eyes see: noise
// of pixels averages out in them, light that is wrong does not.
#pragma once

#include <optional>

#include "trace/gather_frame.hpp"

namespace lippmann {

/// Mean squared errors of sRGB's codes (0 ... 1).
struct FrameError {
  float pixels = 0.0f;
  float blocks = 0.0f;       ///< of means over a patch, 64 pixels
  float uncertainty = 0.0f;  ///< standard deviation of `pixels`
  float block_uncertainty = 0.0f;
};

struct GatherPlan {
  float error = 0.01f;        ///< of GatherParams, where the frame before is known
  float error_alone = 0.01f;  ///< and where not
  float of_cells = 0.0f;      ///< share of the error that frames may have, which no number of samples would take away
  FrameError expected;        ///< of the frame
};

/// Which pixels of a frame are measured.
struct HeldOut {
  std::size_t patches;     ///< enough to know the frame's error; but
  std::size_t small_part;  ///< of a small frame no more than one patch of so many,
  std::size_t large_part;  ///< of a large one no fewer than one of so many
};
/// Where a history is planned, and to check the frames after.
inline constexpr HeldOut kPlanning{96, 12, 96}, kChecking{48, 28, 160};

/// Some patches of a frame, once traced by paths.
class GatherMeasure {
 public:
  /// goal: the mean squared error that pixels may have; none: that of paths with trace.spp samples. likely: how much pixels
  /// scatter, as far as it is known: more patches are taken where this is more, and weigh as much less. All arguments outlive
  /// it.
  GatherMeasure(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display, const TraceParams& trace,
                std::optional<float> goal, const HeldOut& held_out, const Scatter& likely, const ThreadPool& pool);

  /// What frames may err by. Means of patches by kBlockLoss times as much as those of as many paths as the goal takes.
  const FrameError& goal() const { return goal_; }

  /// Paths a pixel that reach the goal.
  int path_samples() const;

  /// The largest error with which pixels from these sources reach the goal, and fewer rays than paths are traced; none where
  /// there is no such. Of frames of which none before is known, and taken for the others, too, until they are planned.
  std::optional<GatherPlan> plan(const GatherSources& sources);
  void plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan);

  /// What was gathered last errs by.
  const FrameError& last() const { return last_; }

  /// What this frame errs by, gathered so. before: as GatherHistory has it.
  FrameError check(const GatherSources& sources, float error, const Scatter& before);

  struct Timed {
    GatherPlan plan;
    bool is_spent = true;  ///< false: the rest of the time would make frames no better
  };
  /// The smallest error with which a frame's pixels are gathered in about `seconds` on this machine; the largest that is tried
  /// where even that takes longer.
  Timed plan_within(const GatherSources& sources, double seconds);

  /// Of paths with trace.spp samples, as far as the patches tell.
  double rays_of_whole_frame() const { return rays_of_paths_ / std::max(of_frame_, 1e-6); }

  /// All that were traced.
  const RayCounts& counts() const { return counts_; }

 private:
  struct Codes {
    std::vector<float> values;  ///< by place
    std::vector<Vec3f> means;   ///< by patch
  };
  Codes codes_at_places(const Image& film) const;
  FrameError error_of(const Image& film) const;
  FrameError gather(const GatherSources& sources, float error, const GatherHistory& history, std::uint32_t frame = 0);
  void refine_for_blocks(const GatherSources& sources, GatherPlan& plan);
  float error_in_a_row(const GatherSources& sources, float error, float enough);

  TraceParams trace_;
  bool has_goal_;
  const ThreadPool& pool_;
  std::vector<std::uint8_t> wanted_;      ///< by packet
  double of_frame_ = 1.0;                 ///< the wanted ones' share of all packets
  std::vector<std::uint32_t> places_;     ///< pixels of these packets, patch by patch
  std::vector<std::size_t> patch_begin_;  ///< in places_; one more than there are patches
  std::vector<double> weights_;           ///< of patches; 1 on average
  Codes paths_[2];
  FrameError of_paths_;  ///< with trace.spp samples
  FrameError goal_, last_;
  double rays_of_paths_ = 0.0, rays_of_last_ = 0.0;  ///< in the measured patches; the latter, of what was gathered last
  RayCounts counts_;
  int next_trial_ = 1;  ///< where to look first: of the errors that are tried
};

}  // namespace lippmann
