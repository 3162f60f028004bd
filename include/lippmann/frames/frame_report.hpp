// What making one frame took, and how good it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lippmann/layout/precompensation.hpp"
#include "lippmann/trace/ray_counts.hpp"

namespace lippmann {

struct FrameReport {
  int frame = 0;
  /// full: traced; key: traced, and others are made from it; in-between: made from others.
  std::string kind = "full";
  double seconds = 0.0;      ///< wall time of rendering, without writing files
  double cpu_seconds = 0.0;  ///< all threads' time together, without writing files
  RayCounts rays;
  std::uint64_t missed_pixels = 0;  ///< onto which no point of another frame projected; for one of two causes:
  std::uint64_t newly_visible_pixels = 0, not_covered_pixels = 0;
  std::uint64_t retraced_pixels = 0;
  std::uint64_t reused_pixels = 0;
  std::optional<double> estimated_psnr_db;  ///< from held-out pixels; none: exact, or not estimated
  std::optional<double> psnr_at_least_db;   ///< the PSNR is higher than this with 95 % confidence; none: no estimate
  std::optional<double> psnr_at_most_db;    ///< the PSNR is lower than this with 95 % confidence; path-traced frames only
  std::optional<Precompensation> precompensation;  ///< what undoing crosstalk cost; none: it was not undone
  bool kept = false;                               ///< finished by an earlier run, which its figures are of
};

}  // namespace lippmann
