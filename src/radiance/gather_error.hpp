// How good frames of cached light are, measured on some of their pixels against paths, and how many samples it takes to be as
// good as is asked for.
//
// Held-out patches, spread over the frame, are traced twice by paths, with random numbers of their own, as are single pixels of
// a frame that is finished (pixel_error.hpp). Means of patches are what lens arrays and eyes see: noise of pixels averages out
// in them, light that is wrong does not.
#pragma once

#include <limits>
#include <optional>

#include "radiance/eye_error.hpp"
#include "radiance/measured_places.hpp"
#include "radiance/pixel_error.hpp"

namespace lippmann {

/// Pixels of a patch, of whose means errors are told.
inline constexpr float kBlockPixels = 64.0f;

/// What pixels may err by, and where.
struct ErrorGoal {
  std::optional<float> squared{};  ///< mean, in sRGB's codes (0 ... 1); none: that of paths with TraceParams::spp samples
  double crosstalk_px = 0.0;       ///< of the display (lippmann/optics/crosstalk.hpp); 0: its lenses are sharp, or not known
  bool at_eye = false;             ///< the goal is for what an eye sees through these lenses; else for single pixels
};

/// Mean squared errors of sRGB's codes (0 ... 1).
struct FrameError {
  float pixels = 0.0f;       ///< of single pixels, or at the eye, as the goal has it
  float blocks = 0.0f;       ///< the errors of means over a patch
  float uncertainty = 0.0f;  ///< standard deviation of `pixels`
  float block_uncertainty = 0.0f;
  PixelError other{};  ///< of single pixels and at the eye, that which the goal is not for
};

struct GatherPlan {
  float error = 0.01f;        ///< GatherEffort::error where the frame before is known
  float error_alone = 0.01f;  ///< and where not
  EdgesToPaths edges = EdgesToPaths::kNone;
  PathMix mix{};
  float worst = std::numeric_limits<float>::infinity();  ///< GatherEffort::worst
  float of_cells = 0.0f;       ///< share of the error that frames may have, which no number of samples would take away
  FrameError expected;         ///< the frame's errors
  double share_of_rays = 1.0;  ///< its rays over those that paths take
  GatherEffort effort() const { return {error, edges, mix, worst}; }
  GatherEffort effort_alone() const { return {error_alone, edges, mix, worst}; }
};

/// What a frame is measured on.
struct MeasuredPlaces {
  std::uint32_t salt;  ///< other places, and other paths, than those with another
  MeasuredShare patches;
  int fewer = 1;  ///< patches have one in so many of a full render's paths: that patches differ says more than paths hide
  MeasuredShare pixels;  ///< one by one, once the whole frame is there; none: patches alone
  bool with_pixels() const { return pixels != MeasuredShare{}; }
};
/// Where a history is planned, where it is found out whether that was luck, and to check its frames, of which the first has
/// none before that would tell more.
inline constexpr MeasuredPlaces kPlanning{1, {96, 12, 96}, 1, {}}, kConfirming{2, {96, 14, 80}, 4, {}},
    kChecking{3, {96, 14, 80}, 4, {1536, 32, 160}}, kCheckingFirst{3, {96, 14, 80}, 4, {3072, 16, 160}};
/// To tell the errors of frames that are traced whole, against one set of paths.
inline constexpr MeasuredShare kWatching{2048, 100, 200};

/// Some patches of a frame, once traced by paths.
class GatherMeasure {
 public:
  /// likely: as choose_patches has it. All arguments outlive it.
  GatherMeasure(const Shot& shot, const TraceParams& trace, const ErrorGoal& goal, const MeasuredPlaces& places,
                const Scatter& likely, const Workers& workers);

  /// Chooses the pixels that are measured one by one, by a picture of the frame and how much its samples scattered, if there
  /// are any to be and they are not chosen yet. Before it no goal is known but one that was asked for.
  void choose_pixels_of(const Image& film, const Scatter& scatter);

  /// What frames may err by. Means of patches by kBlockLoss times as much as those of as many paths as the goal takes.
  const FrameError& goal() const { return goal_; }

  /// Mean squared error of paths with trace.spp samples, of single pixels or at the eye, as the goal has it. Measured where
  /// patches have all of these or pixels are measured one by one; else, as goal(), of no use.
  float of_paths() const { return of_paths_.squared; }

  /// What a picture of the whole frame errs by.
  FrameError error_of(const Image& film) const;

  /// The largest error with which pixels from these sources reach the goal, and fewer rays than paths are traced; none where
  /// there is no such. Of frames of which none before is known, and taken for the others, too, until they are planned.
  std::optional<GatherPlan> plan(const GatherSources& sources);
  void plan_frames_in_a_row(const GatherSources& sources, GatherPlan& plan);

  /// The paths with which frames that err by `found` without any reach the goal; none where they would save nothing.
  /// share_of_rays: what those take, of the rays of paths.
  std::optional<PathMix> mix_for(const FrameError& found, double share_of_rays) const;

  /// What pixels that err by `squared`, each by itself, do with the paths that are mixed in, as the goal has it.
  float with(const PathMix& mix, float squared) const {
    const auto share = static_cast<float>(share_of_independent());
    return errors_of(mix, {share * squared, 0.0f}, path_errors()).pixels;
  }

  /// What frames err by that err by `cached` without the paths that are mixed in.
  FrameError mixed(const PathMix& mix, const FrameError& cached) const;

  /// What frames would err by without the paths that are mixed in.
  FrameError without(const PathMix& mix, const FrameError& found) const;

  /// What was gathered last errs by.
  const FrameError& last() const { return last_; }

  /// What this frame errs by, gathered so. before: as GatherHistory has it.
  FrameError check(const GatherSources& sources, const GatherEffort& effort, const Scatter& before);

  struct Timed {
    GatherPlan plan;
    bool is_spent = true;  ///< false: the rest of the time would make frames no better
  };
  /// The smallest error with which a frame's pixels are gathered in about `seconds` on this machine; the largest that is tried
  /// where even that takes longer.
  Timed plan_within(const GatherSources& sources, double seconds);

  /// What paths with trace.spp samples need, as far as the patches tell.
  double rays_of_whole_frame() const { return rays_of_paths_ / std::max(patches_.of_frame, 1e-6); }

  /// What was gathered last took, of the rays of paths.
  double share_of_last() const { return rays_of_last_ / rays_of_paths_; }

  /// All that were traced.
  const RayCounts& counts() const { return counts_; }

 private:
  struct Codes {
    std::vector<float> values;  ///< the codes of the patches' pixels
    std::vector<float> shown;   ///< their light, as far as it is shown: 0 ... 1
  };
  void trace_patches(int fewer);
  void set_goal(const PixelError& of_paths);
  double share_of_independent() const;
  float worst_pixel() const;
  void set_pixels(const PixelError& single, const PixelError& at_eye, FrameError& error) const;
  PixelError difference(const std::vector<float>& a, const std::vector<float>& b) const;
  Codes codes_of_halves(const std::vector<float>& first, const std::vector<float>& second) const;
  Codes codes_of(const std::vector<float>& light) const;
  FrameError error_of_patches(const Image& film) const;
  PathErrors path_errors() const;
  float path_exponent() const;
  FrameError at_least_some(FrameError error) const;
  FrameError gather(const GatherSources& sources, const GatherEffort& effort, const GatherHistory& history,
                    std::uint32_t frame = 0);
  void refine_for_blocks(const GatherSources& sources, GatherPlan& plan);
  float error_in_a_row(const GatherSources& sources, const GatherEffort& alone, float enough);

  Shot shot_;
  TraceParams trace_;
  ErrorGoal asked_;
  EyeBlur blur_;
  MeasuredPlaces measured_;
  std::uint32_t seed_;
  Workers workers_;  ///< silent: what is measured is no progress of the frame
  MeasuredPatches patches_;
  Codes paths_[2];
  std::optional<PixelMeasure> pixels_;
  std::optional<EyeMeasure> eye_;  ///< of pixels_; none where neighbours are not seen
  PixelError of_single_paths_;     ///< the error of single pixels, with trace.spp samples
  PixelError of_paths_;            ///< the same, or at the eye, as the goal has it
  float of_halves_ = 0.0f;         ///< likewise of patches, with
  int samples_of_half_ = 0;        ///< so many samples; 0: there are no halves
  FrameError goal_, last_;
  double rays_of_paths_ = 0.0, rays_of_last_ = 0.0;  ///< in the measured patches; the latter, of what was gathered last
  RayCounts counts_;
  int next_trial_ = 1;  ///< the error that is tried next is kCoarsest / 2^this
};

}  // namespace lippmann
