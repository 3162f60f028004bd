#include "radiance/plan_search.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// Rays of a whole frame that may be spent to find out how to begin, and that it is better to trace paths: a part of what the
/// history can save.
double most_spent(int frames) { return std::clamp(0.04 * frames, 0.3, 0.65); }

/// The search goes on where that may make frames take no more than this part of the rays that they would take otherwise: it
/// may be in vain. A still has no other frames to make up for that, and rays of shared light take 1.3 to 2.1 times as long as
/// those of paths (nine glTF files at 16 samples a pixel).
constexpr double kLeastGain = 0.8, kLeastGainOfStill = 0.4;

/// Errors of cells fall as the number of updates to the power of one over this: measured, where updates doubled, 0.9 to 2.2 in
/// stills of four scenes (CornellBox, spot, a teapot, nine spheres of glass and gloss).
constexpr double kUpdatesPerExcess = 1.5;

/// So many other places are looked at before a setup is given up, and no more where means err by too much for sure, by so many
/// standard deviations of what was found.
constexpr int kMostLooks = 5;
constexpr float kSurely = 2.5f;

/// Beyond the salts of all other measurements.
constexpr std::uint32_t kSaltsOfConfirming = 16;

/// Rounds of updates that the search begins with. Frames that may err like a few paths are good with the fewest, as a rule: of
/// the room's first frame of 8 paths a pixel (48 views of 128x128) a seventh is saved.
int first_rounds(const TraceParams& params, const CachedLightGoal& goal) {
  constexpr int kFewPaths = 16;
  return !goal.error.squared && !goal.seconds && params.spp <= kFewPaths ? CacheSetup{}.rounds / 2 : CacheSetup{}.rounds;
}

/// Means of patches that err by more than two codes are seen as stains: cells are wider than pixels, and err as a whole. (The
/// white room, 16 paths a pixel: stains at 2.9 codes, next to none at 1.7.)
constexpr float kStained = squared(2.0f / 255.0f);

float excess_of(const FrameError& found, const FrameError& may) {
  return std::max(found.pixels / may.pixels, found.blocks / may.blocks);
}

}  // namespace

PlanSearch::PlanSearch(const Shot& shot, const TraceParams& params, const CachedLightGoal& goal, const Workers& workers,
                       FrameCache& cache)
    : shot_(shot),
      params_(params),
      goal_(goal),
      workers_(workers),
      cache_(cache),
      measure_(shot_, params, goal.error, kPlanning, {}, workers) {}

RayCounts PlanSearch::counts() const {
  RayCounts counts = measure_.counts();
  add(confirming_, counts);
  return counts;
}

std::optional<GatherPlan> PlanSearch::find() {
  const std::atomic<bool>& cancelled = workers_.context.cancelled;
  const float fitting = cache_.fitting_cell();
  SetupSearch search(shot_.device.shaded().path->lights->has(kSkyLight), first_rounds(params_, goal_));
  for (bool goes_on = true; goes_on && !cancelled;) {
    cache_.set_up(search.current(), fitting);
    const SetupOutcome outcome = try_setup(search);
    goes_on = search.go_on(outcome) && may_gain(outcome);
  }
  if (goal_.seconds) return plan_;
  std::optional<Candidate> best = chosen(search);
  if (!best || cancelled) return std::nullopt;
  cache_.set_up(best->setup, fitting);
  measure_.plan_frames_in_a_row(cache_.sources(), best->plan);
  return best->plan;
}

/// A good one before one that takes paths.
std::optional<PlanSearch::Candidate> PlanSearch::chosen(const SetupSearch& search) const {
  if (good_) return Candidate{*search.good(), *good_};
  return mixed_;
}

/// What frames from the cache as it is now err by, and the plan for them.
SetupOutcome PlanSearch::try_setup(const SetupSearch& search) {
  if (goal_.seconds) return try_within(*goal_.seconds);
  plan_ = measure_.plan(cache_.sources());
  SetupOutcome outcome;
  outcome.excess = excess_of(plan_ ? plan_->expected : measure_.last(), measure_.goal());
  const int looks = search.updates_more(outcome) ? 1 : std::clamp(goal_.frames, 1, kMostLooks);
  outcome.is_good = plan_ && is_good_elsewhere(looks);
  outcome.of_cells = plan_ ? plan_->of_cells : 1.0f;
  outcome.is_stained = outcome.is_good && !goal_.error.squared && plan_->expected.blocks > kStained;
  if (outcome.is_good)
    good_ = plan_;
  else if (plan_)
    keep_mixed(search.current());
  return outcome;
}

SetupOutcome PlanSearch::try_within(double seconds) {
  const GatherMeasure::Timed found = measure_.plan_within(cache_.sources(), seconds_for_pixels(seconds));
  plan_ = found.plan;
  // Where time is left, frames get better by what takes longer to begin with.
  return {.is_good = found.is_spent, .excess = found.plan.expected.pixels};
}

/// What a round of updates leaves of a frame's seconds.
double PlanSearch::seconds_for_pixels(double seconds) const {
  constexpr double kLeastShare = 0.2;
  return std::max(kLeastShare * seconds, seconds - cache_.seconds_per_round());
}

/// Among many setups one is good by chance where it was tried: only what is good on other patches, too, is taken. And what
/// means err by is found in few places, for the most part: a setup that seems to be a little too bad is looked at on others,
/// too, until that is not in doubt, as a history that is traced for bad luck of its search takes several times the rays.
/// looks: at so many other places at most; none but to confirm what seems to be good if that is 1.
bool PlanSearch::is_good_elsewhere(int looks) {
  const FrameError& may = measure_.goal();
  FrameError& expected = plan_->expected;
  const auto pool = [](float& mean, float& uncertainty, const PixelError& found, float count) {
    mean += (found.squared - mean) / count;
    uncertainty = std::hypot((count - 1.0f) * uncertainty, found.uncertainty) / count;
  };
  for (int look = 0; look < looks && !workers_.context.cancelled; ++look) {
    const bool was_good = expected.pixels <= may.pixels && expected.blocks <= may.blocks;
    if (!was_good && looks == 1) return false;
    if (expected.pixels - kSurely * expected.uncertainty > may.pixels) return false;
    if (expected.blocks - kSurely * expected.block_uncertainty > may.blocks) return false;
    const FrameError found = found_elsewhere();
    const auto count = static_cast<float>(look + 2);
    pool(expected.pixels, expected.uncertainty, {found.pixels, found.uncertainty}, count);
    pool(expected.blocks, expected.block_uncertainty, {found.blocks, found.block_uncertainty}, count);
    if (was_good && found.pixels - found.uncertainty <= may.pixels && found.blocks - found.block_uncertainty <= may.blocks)
      return true;
  }
  return false;
}

/// What frames by the plan err by on patches that no setup was measured on before: where bright paths have met the few of one
/// place, every setup would seem to be wrong there.
FrameError PlanSearch::found_elsewhere() {
  MeasuredPlaces places = kConfirming;
  places.salt += kSaltsOfConfirming * static_cast<std::uint32_t>(looks_++);
  GatherMeasure fresh(shot_, params_, goal_.error, places, Scatter{}, workers_);
  const FrameError found = fresh.check(cache_.sources(), plan_->effort_alone(), {});
  add(fresh.counts(), confirming_);
  return found;
}

void PlanSearch::keep_mixed(const CacheSetup& setup) {
  Candidate now{setup, *plan_};
  const std::optional<PathMix> mix = measure_.mix_for(now.plan.expected, now.plan.share_of_rays);
  if (!mix) return;
  now.plan.mix = *mix;
  now.plan.expected = measure_.mixed(*mix, now.plan.expected);
  now.plan.share_of_rays += static_cast<double>(mix->samples) / params_.spp;
  if (!mixed_ || now.plan.share_of_rays < mixed_->plan.share_of_rays) mixed_ = now;
}

/// Whether it may pay to try what comes next.
bool PlanSearch::may_gain(const SetupOutcome& outcome) const {
  if (goal_.seconds) return true;
  const double whole = measure_.rays_of_whole_frame(), frames = goal_.frames;
  if (static_cast<double>(cache_.counts().total() + counts().total()) >= most_spent(goal_.frames) * whole) return false;
  const double share = frames * measure_.share_of_last() * whole;
  if (good_ && outcome.is_stained)
    return share + 2.0 * static_cast<double>(cache_.rays_since_start()) < kLeastGainOfStill * frames * whole;
  if (good_) return updates_pay(outcome, share, static_cast<double>(cache_.rays_since_start()));
  const double after = share + rays_until_good(outcome);
  if (mixed_) return after < kLeastGain * frames * mixed_->plan.share_of_rays * whole;
  return after < (goal_.frames > 1 ? kLeastGain : kLeastGainOfStill) * frames * whole;
}

/// What updates may still take until frames are good, if cells are all that is wrong.
double PlanSearch::rays_until_good(const SetupOutcome& outcome) const {
  const double more = std::pow(std::max(static_cast<double>(outcome.excess), 1.0), kUpdatesPerExcess) - 1.0;
  return more * static_cast<double>(cache_.rays_since_start());
}

}  // namespace lippmann
