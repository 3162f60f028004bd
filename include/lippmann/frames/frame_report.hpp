// Statistics of a rendered frame: time, rays, reuse and estimated error.
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
  /// "full": a traced frame. "key": a traced frame from which other frames take pixels. "in-between": a frame made from other
  /// frames.
  std::string kind = "full";
  double seconds = 0.0;      ///< wall-clock time of rendering, without writing files
  double cpu_seconds = 0.0;  ///< CPU time of all threads, without writing files
  RayCounts rays{};
  /// Number of pixels onto which no point of another frame projects: newly_visible_pixels + not_covered_pixels.
  std::uint64_t missed_pixels = 0;
  std::uint64_t newly_visible_pixels = 0, not_covered_pixels = 0;
  /// Number of traced pixels in a frame that is made from other frames.
  std::uint64_t retraced_pixels = 0;
  std::uint64_t reused_pixels = 0;  ///< number of pixels taken from other frames
  /// Estimated PSNR in dB, from held-out pixels. Empty if the frame is exact or has no estimate.
  std::optional<double> estimated_psnr_db{};
  /// Lower limit of the PSNR in dB, with 95 % confidence. Empty without an estimate.
  std::optional<double> psnr_at_least_db{};
  /// Upper limit of the PSNR in dB, with 95 % confidence. Only for path-traced frames.
  std::optional<double> psnr_at_most_db{};
  std::optional<Precompensation> precompensation{};  ///< figures of crosstalk compensation; empty without compensation
  /// True if an earlier run rendered the frame. All values are then from that run.
  bool kept = false;
};

}  // namespace lippmann
