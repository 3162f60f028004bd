// Renders one frame: where everything is at its time, the scene made ready for tracing, every pixel traced.
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

/// What stays the same from frame to frame, set up once.
struct Stage {
  Scene scene;
  FittedArray array;
  PlacedOptics placed;
  DeviceScene device;  ///< refers to `scene`: a Stage stays where it was made
  FilmRows rows{};     ///< of every frame that are rendered (strip_maker.hpp)

  /// Builds what rays are traced against. The scene passes validate().
  Stage(Scene scene, FittedArray array, PlacedOptics placed, Integrator integrator, const ThreadPool& pool);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Where everything is in a frame.
  Moment moment_at(int frame) const;
  Moment moment_at_time(double seconds) const;

  /// What is rendered of the moment that the device scene was moved to.
  Shot shot(const Moment& moment) const { return {device, placed.optics, moment.world_from_display, rows}; }
};

/// Measures the rendering of one frame, from its making on.
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

/// One of the times that a frame with motion blur is exposed at, and the samples that are traced then.
struct ExposureTime {
  double seconds = 0.0;
  SampleShare share;
};

/// The samples of a pixel in their order, spread evenly over the time that the shutter is open.
std::vector<ExposureTime> exposure_times(const Sampling& sampling, const Timeline& timeline, int frame);

/// Which layers a frame has to have.
FrameAovs wanted_aovs(const Sampling& sampling);

/// Where the layer of provenance is wanted: all pixels of the frame came from there.
void set_provenance(Provenance all, Vec2i film_size, FrameAovs& aovs);

/// Likewise, by pixel, values of Provenance; none: all were traced.
void set_provenance(std::span<const std::uint8_t> of_pixels, Vec2i film_size, FrameAovs& aovs);

/// How frames are traced. Quilts that displays show are seen as beams as wide as a view, unless `sampling` asks for something
/// else.
TraceParams trace_params(const Sampling& sampling, const Stage& stage);

/// Fills the layers that do not come with the light; the device scene is at the frame's `moment`.
void add_first_hits(const Stage& stage, const Sampling& sampling, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs);

/// Moves the device scene to the frame's time and traces it; `touched` as for trace_frame. Unfinished when context.cancelled is
/// set meanwhile.
RenderedFrame render_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched = nullptr);

/// The same frame with its film in `noisy`, and what the denoiser needs beside it.
RenderedFrame render_noisy_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool,
                                 const Context& context, NoisyFrame& noisy);

}  // namespace lippmann
