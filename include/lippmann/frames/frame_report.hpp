// Time, rays, reuse and estimated error of one rendered frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lippmann/layout/precompensation.hpp"
#include "lippmann/trace/ray_counts.hpp"

namespace lippmann {

/// Statistics of one rendered frame.
struct FrameReport {
  int frame = 0;
  /// "full": traced; "key": traced, and other frames take pixels from it; "in-between": made from other frames.
  std::string kind = "full";
  double seconds = 0.0;      ///< wall-clock time of rendering, without writing files
  double cpu_seconds = 0.0;  ///< CPU time of all threads, without writing files
  RayCounts rays{};
  /// Pixels onto which no point of another frame projects: the sum of newly_visible_pixels and not_covered_pixels.
  std::uint64_t missed_pixels = 0;
  std::uint64_t newly_visible_pixels = 0, not_covered_pixels = 0;
  std::uint64_t retraced_pixels = 0;          ///< pixels that were traced although the frame is made from other frames
  std::uint64_t reused_pixels = 0;            ///< pixels taken from other frames
  std::optional<double> estimated_psnr_db{};  ///< in dB, from held-out pixels; empty if the frame is exact or has no estimate
  std::optional<double> psnr_at_least_db{};   ///< the PSNR is higher than this with 95 % confidence; empty without an estimate
  std::optional<double> psnr_at_most_db{};    ///< the PSNR is lower than this with 95 % confidence; only for path-traced frames
  std::optional<Precompensation> precompensation{};  ///< figures of crosstalk compensation; empty if there was none
  bool kept = false;  ///< true: an earlier run rendered the frame, and all values are from that run
};

}  // namespace lippmann
