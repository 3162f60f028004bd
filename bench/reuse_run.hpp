// Renders an animation fully traced and with several kinds of reuse, and compares them frame by frame: time and likeness.
//
// CPU seconds of rendering alone, of all threads. Frames are rendered in turns of eight by every method, so that each finds the
// machine as the others do, and where there are several rounds, of each frame and method the least counts. Traced means by our
// own fastest full tracing, the baseline of all savings.
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
  bool key = false;  ///< traced as a whole
  double traced_seconds = 0.0, seconds = 0.0;
  PictureMetrics likeness;            ///< to the traced frame
  std::optional<double> moving_psnr;  ///< dB, over the pixels that differ between the two key frames; none: there are none
  double blend_psnr = 0.0;            ///< dB, of the mean of the two key frames, which uses no motion
  std::uint64_t missed_pixels = 0;
};

struct ReuseRun {
  std::string scene, method;
  int keyframes = 0;
  std::size_t pixels = 0;  ///< in a frame
  std::vector<ReuseFrame> frames;

  double traced_seconds() const;
  double seconds() const;
  double saving() const { return 1.0 - seconds() / traced_seconds(); }
  double saving_in_between() const;
  /// Means over in-between frames; PSNR over those that differ at all. None where there are no such frames.
  std::optional<double> mean_psnr() const;
  std::optional<double> min_psnr() const;  ///< likewise
  std::optional<double> mean_moving_psnr() const;
  std::optional<double> mean_blend_psnr() const;
  double mean_ssim() const;
  double missed_share() const;
};

struct ReuseMethod {
  std::string name;
  RenderParams params;  ///< with reuse; forward: a key frame interval of 2, 4 or 8, or none
};

/// One run per method, in their order. Throws Error where a frame traced as a whole, or made by exact reuse, is not the traced
/// one to the bit.
std::vector<ReuseRun> run_reuse(const BenchAnimation& animation, const std::vector<ReuseMethod>& methods,
                                const Request& request, const Context& context, int rounds = 1);

}  // namespace lippmann::bench
