// Renders an animation with full tracing and with several kinds of reuse. Compares CPU time and error frame by frame.
//
// The methods alternate after every eight frames, so that changes in the machine's speed affect all methods. With several
// rounds, the minimum time of each frame and method counts. Savings are relative to our fastest full tracing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/scenes.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann::bench {

struct ReuseFrame {
  int frame = 0;
  bool key = false;
  double traced_seconds = 0.0, seconds = 0.0;
  PictureMetrics likeness;
  /// PSNR in dB over the pixels that differ between the two key frames; no value if no pixel differs
  std::optional<double> moving_psnr;
  double blend_psnr = 0.0;  ///< PSNR in dB of the mean of the two key frames, which ignores motion
  std::uint64_t missed_pixels = 0;
};

struct ReuseRun {
  std::string scene, method;
  int keyframes = 0;
  std::size_t pixels = 0;
  std::vector<ReuseFrame> frames;

  double traced_seconds() const;
  double seconds() const;
  double saving() const { return 1.0 - seconds() / traced_seconds(); }
  double saving_in_between() const;
  /// The mean or the minimum over the in-between frames that differ from the traced frames; no value if none differs.
  std::optional<double> mean_psnr() const;
  std::optional<double> min_psnr() const;
  std::optional<double> mean_moving_psnr() const;
  std::optional<double> mean_blend_psnr() const;
  double mean_ssim() const;
  double missed_share() const;
};

struct ReuseMethod {
  std::string name;
  RenderParams params;  ///< select the reuse; for interpolation, the key frame interval must be 2, 4, 8 or empty
};

/// Returns one run for each method. Throws Error if a frame of an exact method (full tracing or copying) differs in any bit
/// from the frame that the benchmark traced as the reference.
std::vector<ReuseRun> run_reuse(const BenchAnimation& animation, const std::vector<ReuseMethod>& methods,
                                const Request& request, const Context& context, int rounds = 1);

}  // namespace lippmann::bench
