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

struct Stage {
  Scene scene;
  FittedArray array;
  PlacedOptics placed;
  DeviceScene device;  ///< refers to `scene`, so a Stage cannot be moved
  FilmRows rows{};

  Stage(Scene scene, FittedArray array, PlacedOptics placed, Integrator integrator, const ThreadPool& pool);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  Moment moment_at(int frame) const;
  Moment moment_at_time(double seconds) const;

  /// The device scene must have been moved to `moment`.
  Shot shot(const Moment& moment) const { return {device, placed.optics, moment.world_from_display, rows}; }
};

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

/// One of the times at which a frame with motion blur is exposed, and the fraction of samples that it gets.
struct ExposureTime {
  double seconds = 0.0;
  SampleShare share;
};

std::vector<ExposureTime> exposure_times(const Sampling& sampling, const Timeline& timeline, int frame);

FrameAovs wanted_aovs(const Sampling& sampling);

void set_provenance(Provenance all, Vec2i film_size, FrameAovs& aovs);

/// `of_pixels` has one Provenance per pixel, or is empty if all pixels were traced.
void set_provenance(std::span<const std::uint8_t> of_pixels, Vec2i film_size, FrameAovs& aovs);

/// Unless `sampling` selects an angular filter, the pixels of a display's quilt average rays over the angle of a view.
TraceParams trace_params(const Sampling& sampling, const Stage& stage);

void add_first_hits(const Stage& stage, const Sampling& sampling, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs);

RenderedFrame render_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched = nullptr);

/// Like render_frame(), but stores the film and the denoiser's other inputs in `noisy`.
RenderedFrame render_noisy_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool,
                                 const Context& context, NoisyFrame& noisy);

}  // namespace lippmann
