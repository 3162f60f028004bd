// Renders one frame: where everything is at its time, the scene made ready for tracing, every pixel traced.
#pragma once

#include <chrono>
#include <memory>

#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/render/fit_array.hpp"
#include "lippmann/render/rendered_frame.hpp"
#include "lippmann/scene/load.hpp"
#include "render/make_optics.hpp"
#include "render/params.hpp"
#include "reuse/point_image.hpp"
#include "trace/device_scene.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// What stays the same from frame to frame, set up once.
struct Stage {
  std::unique_ptr<const Display> display;  ///< none: optics of the parameters alone
  Scene scene;
  std::string light;  ///< SceneNotes::light; empty where the scene was there already
  FittedArray array;
  PlacedOptics placed;
  DeviceScene device;  ///< of `scene`: a Stage stays where it was made

  /// Loads the scene, fits the array and builds what rays are traced against. Throws Error.
  Stage(const RenderParams& params, const ThreadPool& pool, const Context& context);
  /// The same for a scene that is there already and passes validate(); it is lit by what it holds, whatever environment the
  /// parameters name. Throws Error.
  Stage(Scene scene, const RenderParams& params, const ThreadPool& pool);
  /// The same for optics that have their place already, too.
  Stage(Scene scene, FittedArray array, PlacedOptics placed, Integrator integrator, const ThreadPool& pool);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Where everything is in a frame.
  Moment moment_at(int frame) const;

 private:
  /// notes: room for what loading the scene finds out.
  Stage(SceneNotes notes, const RenderParams& params, const ThreadPool& pool, const Context& context);
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

/// As said; else kBox for quilts that displays show, which show them as beams as wide as a view, where there are several
/// samples and no points to be moved.
AngularFilter wanted_angular_filter(const FrameParams& params, const PlacedOptics& placed);

/// Throws a usage Error where the filter that is said cannot be.
void check_angular_filter(const FrameParams& params, const Optics& optics);

/// How the parameters have a frame traced.
TraceParams trace_params(const FrameParams& params, const Stage& stage);

/// Fills the layers that do not come with the light; the device scene is at the frame's `moment`.
void add_first_hits(const Stage& stage, const FrameParams& params, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs);

/// Moves the device scene to the frame's time and traces it; `touched` as for trace_frame. Unfinished when context.cancelled is
/// set meanwhile.
RenderedFrame render_frame(Stage& stage, const FrameParams& params, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched = nullptr);

}  // namespace lippmann
