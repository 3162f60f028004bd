// Statistics of one rendered frame: time, rays, reuse and estimated error.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lippmann/layout/precompensation.hpp"
#include "lippmann/trace/ray_counts.hpp"

namespace lippmann {

struct FrameReport {
  int frame = 0;
  /// "full": a traced frame. "key": a traced frame from which other frames take pixels. "in-between": a frame made from other
  /// frames.
  std::string kind = "full";
  double seconds = 0.0;      ///< elapsed time of rendering, without writing files
  double cpu_seconds = 0.0;  ///< CPU time of all threads, without writing files
  RayCounts rays{};
  /// Pixels onto which no point of another frame projects.
  std::uint64_t missed_pixels = 0;
  std::uint64_t newly_visible_pixels = 0, not_covered_pixels = 0;
  /// Traced pixels in a frame that is made from other frames.
  std::uint64_t retraced_pixels = 0;
  std::uint64_t reused_pixels = 0;  ///< pixels taken from other frames
  /// Estimated PSNR in dB. Empty if the frame is exact or has no estimate.
  std::optional<double> estimated_psnr_db{};
  /// Lower limit of the PSNR in dB, with 95 % confidence.
  std::optional<double> psnr_at_least_db{};
  /// Upper limit of the PSNR in dB, with 95 % confidence. Only for path-traced frames.
  std::optional<double> psnr_at_most_db{};
  std::optional<Precompensation> precompensation{};  ///< empty if crosstalk was not compensated
  /// An earlier run rendered the frame, and all values are from that run.
  bool kept = false;
};

}  // namespace lippmann
