// How a history of cached light may begin, and what to try next where that is not good enough. Private to src/trace.
#pragma once

#include <optional>

#include "trace/light_table.hpp"

namespace lippmann {

struct Beginning {
  float cell = 1.0f;                            ///< samples across the smallest cells, in parts of what fits
  int rounds = 4;                               ///< of feeding (feed_frame.hpp)
  LightGroup lights_from = LightGroup::kLamps;  ///< the lights that the cache holds (LightCells), of which a sun is never one
};

/// What came of one.
struct BeginningOutcome {
  bool is_good = false;   ///< frames may err so much
  float excess = 0.0f;    ///< the larger of the two errors, of pixels and of blocks, over what it may be
  float of_cells = 0.0f;  ///< share of the allowed error that cells make
};

/// More light where cells are too noisy; lamps, then the sky asked at every point where cells blur their shadows; smaller cells
/// where it is other light that they blur. What has not helped is not tried again.
class Beginnings {
 public:
  Beginnings(bool has_lamps, bool has_sky) : has_lamps_(has_lamps), has_sky_(has_sky) {}

  const Beginning& current() const { return current_; }

  /// Makes current what is worth trying after the current one; false: nothing is.
  bool go_on(const BeginningOutcome& outcome);

  /// The good one that was tried last.
  const std::optional<Beginning>& good() const { return good_; }

 private:
  enum class Step { kMore, kAsked, kSmaller };

  bool has_helped(const BeginningOutcome& outcome) const { return outcome.excess < kHelped * last_excess_; }
  std::optional<LightGroup> next_group() const;
  bool ask_more();
  bool shrink();

  static constexpr float kHelped = 0.8f;
  bool has_lamps_, has_sky_;
  Beginning current_;
  std::optional<Beginning> good_;
  Step step_ = Step::kMore;
  float last_excess_ = kInfinity;
  bool has_asked_in_vain_ = false;
};

}  // namespace lippmann
