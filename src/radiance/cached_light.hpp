// Path-traced frames at the price of a few samples: what is seen, mirrored and lit by point-like lights is traced, more often
// where samples differ; soft light comes from a radiance cache that all pixels, views and frames share.
#pragma once

#include <memory>
#include <optional>

#include "lippmann/scene/timeline.hpp"
#include "radiance/gather_error.hpp"
#include "trace/noisy_frame.hpp"

namespace lippmann {

/// What is known of a frame's errors, from some of its blocks.
struct CachedLightReport {
  RayCounts rays;
  bool traced = false;               ///< whole paths, as they were cheaper
  PixelError pixels;                 ///< of single pixels, as measured
  PixelError at_eye;                 ///< of what an eye sees through the display's lenses; without crosstalk the same
  double block_squared_error = 0.0;  ///< the same for means over 64 pixels
};

/// What pictures should be like.
struct CachedLightGoal {
  ErrorGoal error{};
  int frames = 1;                   ///< that a history will have
  bool provenance = false;          ///< pictures show where light came from: see trace/final_gather.hpp
  std::optional<double> seconds{};  ///< a frame's on this machine, in place of an error: frames are as good as that allows
};

/// Where a frame goes.
struct CachedLightPictures {
  Image& film;
  /// Alpha and provenance alone are filled, where they are wanted; alpha must be for all frames of a history, or for none.
  FrameAovs* aovs = nullptr;
  NoisyFrame* noisy = nullptr;  ///< receives what a denoiser wants to know beside the film, which stays without; else null
};

class CachedLightTracer {
 public:
  /// `scene` was made for Integrator::kPath, and outlives it.
  explicit CachedLightTracer(const DeviceScene& scene);
  ~CachedLightTracer();

  /// Forgets all frames: the next one begins a history.
  void restart();

  /// A frame, as trace_frame. `shot` is of the scene that this was made for, `resolved` what that was updated with. What the
  /// frames before it, since restart(), have found helps: they must be the same, in the same order, for the same bits. Not so
  /// where the goal is a time: then samples go by the clock. moving: boxes around everything that has moved since the frame
  /// before, at both places; without end: light may have changed everywhere. Errors are those of pictures that show the
  /// surroundings.
  CachedLightReport trace(const Shot& shot, const ResolvedScene& resolved, const TraceParams& params,
                          const CachedLightGoal& goal, const std::vector<HorizonBox>& moving, const Workers& workers,
                          const CachedLightPictures& pictures);

  /// What tracing takes and keeps per pixel, for a share of pixels that see a surface: within a factor of 1.5 of what was
  /// measured (docs/decisions/0079-memory-is-estimated-by-part.md). The cache may grow to several times as much.
  static double bytes_per_pixel(double covered);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
