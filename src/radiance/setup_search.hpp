// How the radiance cache of a history may be set up, and what to try next where that is not good enough.
#pragma once

#include <optional>

#include "shading/light_table.hpp"

namespace lippmann {

struct CacheSetup {
  float cell = 1.0f;  ///< samples across the smallest cells, in parts of what fits
  int rounds = 4;     ///< rounds of updates in the first frame (update_frame.hpp)
  /// The light that the cache holds (CacheCells). What comes straight from lamps is never in it: cells would blur its shadows
  /// over their own width, which eyes see where means over pixels do not.
  LightGroup lights_from = LightGroup::kSky;
};

/// How good frames are with one.
struct SetupOutcome {
  bool is_good = false;  ///< frames may err so much
  /// The larger of the two errors, of pixels and of blocks, over what it may be: in places that are the same for all setups,
  /// so that they can be compared, though there is luck in how large it is.
  float excess = 0.0f;
  float of_cells = 0.0f;  ///< share of the allowed error that cells make
  /// Means err by so much that stains are seen, though those of as few paths err as much: their noise is finer.
  bool is_stained = false;
};

/// Whether twice the updates of a good setup may save clearly more samples of pixels than they cost. rays: what the pixels of
/// all frames are going to take with it; rays_of_updates: what its updates took.
bool updates_pay(const SetupOutcome& outcome, double rays, double rays_of_updates);

/// More light where cells are too noisy; the sky sampled at every point where cells blur its shadows; smaller cells where it is
/// other light that they blur. What has not helped is not tried again.
class SetupSearch {
 public:
  /// first_rounds: of the first setup.
  SetupSearch(bool has_sky, int first_rounds) : may_ask_sky_(has_sky) { current_.rounds = first_rounds; }

  const CacheSetup& current() const { return current_; }

  /// Makes current what is worth trying after the current one; false: nothing is.
  bool go_on(const SetupOutcome& outcome);

  /// Whether more updates of the current one are tried next, should it not be good.
  bool updates_more(const SetupOutcome& outcome) const;

  /// The good one that was tried last.
  const std::optional<CacheSetup>& good() const { return good_; }

 private:
  enum class Step { kMore, kAsked, kSmaller };

  bool has_helped(const SetupOutcome& outcome) const { return outcome.excess < kHelped * last_excess_; }
  bool ask_sky();
  bool shrink();

  static constexpr float kHelped = 0.8f;
  bool may_ask_sky_;
  CacheSetup current_;
  std::optional<CacheSetup> good_;
  Step step_ = Step::kMore;
  float last_excess_ = kInfinity;
};

}  // namespace lippmann
