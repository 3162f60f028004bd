// Renders one frame: moves the scene to the frame's time and traces all pixels.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/frames/frame_params.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/placement.hpp"
#include "reuse/point_image.hpp"
#include "trace/device_scene.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// The parts of rendering that are set up once for all frames.
struct Stage {
  Scene scene;
  FittedArray array;
  PlacedOptics placed;
  DeviceScene device;  ///< refers to `scene`, so a Stage cannot be moved
  FilmRows rows{};     ///< the rows of every frame to render (strip_maker.hpp)

  /// Builds the device scene. The scene must pass validate().
  Stage(Scene scene, FittedArray array, PlacedOptics placed, Integrator integrator, const ThreadPool& pool);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Return the state of the scene at a frame or a time.
  Moment moment_at(int frame) const;
  Moment moment_at_time(double seconds) const;

  /// Returns the shot for the moment that the device scene was moved to.
  Shot shot(const Moment& moment) const { return {device, placed.optics, moment.world_from_display, rows}; }
};

/// Measures the time of rendering one frame, starting at construction.
class FrameClock {
 public:
  explicit FrameClock(const ThreadPool& pool) : pool_(pool), cpu_start_(pool.cpu_seconds()) {}
  void add_to(FrameReport& report) const {
    report.seconds += std::chrono::duration<double>(Clock::now() - start_).count();
    report.cpu_seconds += pool_.cpu_seconds() - cpu_start_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  const ThreadPool& pool_;
  Clock::time_point start_ = Clock::now();
  double cpu_start_;
};

/// One of the times at which a frame with motion blur is exposed, and its share of the samples.
struct ExposureTime {
  double seconds = 0.0;
  SampleShare share;
};

/// Returns times spread evenly over the open time of the shutter, each with its share of the samples of every pixel.
std::vector<ExposureTime> exposure_times(const Sampling& sampling, const Timeline& timeline, int frame);

/// Returns the layers that a frame needs.
FrameAovs wanted_aovs(const Sampling& sampling);

/// Fills the provenance layer, if wanted, with one value for all pixels.
void set_provenance(Provenance all, Vec2i film_size, FrameAovs& aovs);

/// Fills the provenance layer, if wanted, from values of Provenance by pixel. If `of_pixels` is empty, all pixels were traced.
void set_provenance(std::span<const std::uint8_t> of_pixels, Vec2i film_size, FrameAovs& aovs);

/// Returns the parameters for tracing. Quilts for displays use beams as wide as a view, unless `sampling` selects another
/// filter.
TraceParams trace_params(const Sampling& sampling, const Stage& stage);

/// Fills the layers that are computed separately from the light. The device scene must be at the frame's `moment`.
void add_first_hits(const Stage& stage, const Sampling& sampling, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs);

/// Moves the device scene to the frame's time and traces the frame. `touched` has the meaning of TraceTargets::touched. The
/// result is incomplete if context.cancelled is set meanwhile.
RenderedFrame render_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched = nullptr);

/// Renders the same frame with its film and the denoiser's inputs in `noisy`.
RenderedFrame render_noisy_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool,
                                 const Context& context, NoisyFrame& noisy);

}  // namespace lippmann
