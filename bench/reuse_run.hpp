// Renders an animation fully traced and with several kinds of reuse, and compares them frame by frame: CPU time and error.
//
// CPU seconds are the rendering time of all threads. The methods take turns of eight frames each, so that changes in the
// machine's speed affect all of them. With several rounds, the minimum counts for each frame and method. The baseline of all
// savings is our fastest full tracing.
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
  bool key = false;  ///< fully traced
  double traced_seconds = 0.0, seconds = 0.0;
  PictureMetrics likeness;            ///< compared with the traced frame
  std::optional<double> moving_psnr;  ///< dB, over the pixels that differ between the two key frames; no value without such
                                      ///< pixels
  double blend_psnr = 0.0;            ///< dB, of the mean of the two key frames, which ignores motion
  std::uint64_t missed_pixels = 0;
};

struct ReuseRun {
  std::string scene, method;
  int keyframes = 0;
  std::size_t pixels = 0;  ///< per frame
  std::vector<ReuseFrame> frames;

  double traced_seconds() const;
  double seconds() const;
  double saving() const { return 1.0 - seconds() / traced_seconds(); }
  double saving_in_between() const;
  /// Mean and minimum over in-between frames that differ from the traced ones; no value without such frames.
  std::optional<double> mean_psnr() const;
  std::optional<double> min_psnr() const;
  std::optional<double> mean_moving_psnr() const;
  std::optional<double> mean_blend_psnr() const;
  double mean_ssim() const;
  double missed_share() const;
};

struct ReuseMethod {
  std::string name;
  RenderParams params;  ///< with reuse; forward: a key frame interval of 2, 4 or 8, or none
};

/// Returns one run per method, in order. Throws Error if a fully traced frame, or one made by exact reuse, differs from the
/// traced frame in any bit.
std::vector<ReuseRun> run_reuse(const BenchAnimation& animation, const std::vector<ReuseMethod>& methods,
                                const Request& request, const Context& context, int rounds = 1);

}  // namespace lippmann::bench
