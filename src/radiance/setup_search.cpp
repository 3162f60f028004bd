#include "radiance/setup_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radiance/block_estimates.hpp"

namespace lippmann {
namespace {

/// So many rounds are tried whether fewer have helped or not; more of them than the latter are never worth it.
constexpr int kFewRounds = 16, kMostRounds = 64;
/// Where the error is beyond this many times what it may be, four times the rounds are tried at once: twice as many would not
/// do.
constexpr float kFar = 4.0f;
/// Rounds that cells of another size or of other light begin with.
constexpr int kRoundsAnew = 32, kRoundsOfSmall = 32;
constexpr float kSmallestPart = 0.25f;

/// Share of the error that cells may make after so many rounds: where it is more, twice the updates save more samples of
/// pixels than they cost.
float most_of_cells(int rounds) { return rounds <= 4 ? 0.4f : rounds <= 8 ? 0.7f : 1.0f; }

}  // namespace

bool updates_pay(const SetupOutcome& outcome, double rays, double rays_of_updates) {
  // Light is measured again, too, and what an edge takes stays.
  constexpr double kWorth = 2.0;
  // Cells make half the error then; samples fall as what is left to them to the power of one over kErrorFall.
  const double of_cells = std::clamp(static_cast<double>(outcome.of_cells), 0.0, 0.9);
  const double left = std::pow((1.0 - of_cells) / (1.0 - 0.5 * of_cells), 1.0 / static_cast<double>(kErrorFall));
  return rays * (1.0 - left) > kWorth * rays_of_updates;
}

bool SetupSearch::updates_more(const SetupOutcome& outcome) const {
  return current_.rounds < kFewRounds || (has_helped(outcome) && 2 * current_.rounds <= kMostRounds);
}

bool SetupSearch::go_on(const SetupOutcome& outcome) {
  const bool helped = has_helped(outcome);
  if (outcome.is_good) {
    good_ = current_;
    if (!outcome.is_stained && outcome.of_cells <= most_of_cells(current_.rounds)) return false;
  }
  const Step done = step_;
  const bool more = updates_more(outcome);
  last_excess_ = outcome.excess;
  if (done == Step::kAsked && !helped) {
    current_.lights_from = CacheSetup{}.lights_from;
    return !good_ && shrink();
  }
  if (more) {
    step_ = Step::kMore;
    current_.rounds = std::min((outcome.excess > kFar ? 4 : 2) * current_.rounds, kMostRounds);
    return true;
  }
  return !good_ && (ask_sky() || (helped || done == Step::kMore ? shrink() : false));
}

bool SetupSearch::ask_sky() {
  if (!std::exchange(may_ask_sky_, false)) return false;
  step_ = Step::kAsked;
  current_.lights_from = LightGroup::kEnd, current_.rounds = kRoundsAnew;
  return true;
}

bool SetupSearch::shrink() {
  if (!(current_.cell > kSmallestPart)) return false;
  step_ = Step::kSmaller;
  current_.cell *= 0.5f, current_.rounds = std::max(current_.rounds, kRoundsOfSmall);
  return true;
}

}  // namespace lippmann
