// How good frames of cached light are, measured on some of their pixels against paths, and how many samples it takes to be as
// good as is asked for. Private to src/trace.
#pragma once

#include <optional>

#include "trace/gather_frame.hpp"

namespace lippmann {

struct GatherPlan {
  float error = 0.01f;         ///< of GatherParams, where the frame before is known
  float error_alone = 0.01f;   ///< and where not
  float of_cells = 0.0f;       ///< share of the error that frames may have, which no number of samples would take away
  float squared_error = 0.0f;  ///< to be expected of the frame: mean, of sRGB's codes (0 ... 1)
};

/// Some patches of a frame, once traced by paths.
class GatherMeasure {
 public:
  /// goal: the mean squared error that frames may have; none: that of paths with trace.spp samples. All arguments outlive it.
  GatherMeasure(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display, const TraceParams& trace,
                std::optional<float> goal, const ThreadPool& pool);

  float squared_goal() const { return squared_goal_; }

  /// Paths a pixel that reach the goal.
  int path_samples() const;

  /// The largest error with which frames from these sources reach the goal, and fewer rays than paths are traced; none where
  /// there is no such. Of frames of which none before is known, and taken for the others, too, until they are planned.
  std::optional<GatherPlan> plan(const GatherSources& sources);
  void plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan);

  struct Timed {
    GatherPlan plan;
    bool is_spent = true;  ///< false: the rest of the time would make frames no better
  };
  /// The smallest error with which a frame's pixels are gathered in about `seconds` on this machine; the largest that is tried
  /// where even that takes longer.
  Timed plan_within(const GatherSources& sources, double seconds);

  /// All that were traced.
  const RayCounts& counts() const { return counts_; }

 private:
  float squared_error(const Image& film) const;
  float gather(const GatherSources& sources, float error, const GatherHistory& history, std::uint32_t frame = 0);
  float error_in_a_row(const GatherSources& sources, float error, float enough);

  TraceParams trace_;
  bool has_goal_;
  const ThreadPool& pool_;
  std::vector<std::uint8_t> wanted_;     ///< by packet
  double of_frame_ = 1.0;                ///< the wanted ones' share of all packets
  std::vector<std::size_t> places_;      ///< values of a film that belong to these packets
  std::vector<float> paths_;             ///< there: the mean of all paths
  float squared_error_of_paths_ = 0.0f;  ///< of trace.spp; of all of them half that
  float squared_goal_ = 0.0f;
  double rays_of_paths_ = 0.0, rays_of_last_ = 0.0;  ///< in the measured patches; the latter, of what was gathered last
  RayCounts counts_;
  int next_trial_ = 3;  ///< where to look first: of the errors that are tried
};

}  // namespace lippmann
