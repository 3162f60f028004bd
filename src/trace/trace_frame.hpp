// Renders one frame. Traces each pixel's rays through the lens array, and shades them by the DeviceScene's integrator.
#pragma once

#include <cstdint>
#include <span>

#include "device/touched_blocks.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/ray_counts.hpp"
#include "lippmann/trace/ray_order.hpp"
#include "trace/primary_points.hpp"
#include "trace/sample_share.hpp"
#include "trace/shot.hpp"

namespace lippmann {

struct TraceParams {
  RayOrder order = RayOrder::kViewTiles;
  int spp = 1;        ///< samples per pixel; several samples are stratified over the pixel's area
  int max_depth = 6;  ///< maximum number of vertices of a path; 1: no mirrors
  /// How the pixels of a view are filtered over directions; needs more than 1 sample per pixel.
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};  ///< must specify its aperture (lens_by_aperture)
  /// Seed of sample positions within pixels; constant over frames, so that static parts do not flicker.
  std::uint32_t seed = 0;
  std::uint32_t frame = 0;  ///< path tracing only: number of the frame, which makes the noise of frames different
  /// Path tracing only: upper limit of one path's indirect light. A limit makes images darker; 0: no limit.
  float clamp_indirect = 0.0f;
};

struct TraceTargets {
  Image& film;  ///< resized to film_size(shot), with 3 linear channels
  /// Path tracing only: layers of light; find_first_hits() in trace/first_hits.hpp fills the other layers.
  FrameAovs* aovs = nullptr;
  /// Receives the first hits behind the pixels' centres; may be null. Recording is free with one sample per pixel. With several
  /// samples, it takes an extra pass.
  PrimaryPoints* points = nullptr;
  TouchedBlocks* touched = nullptr;  ///< input: boxes; output: the blocks whose rays hit the boxes; may be null
};

/// Traces a frame. The result does not depend on the number of threads. After cancellation, returns early with an unfinished
/// film.
/// `share` selects samples, all of which have the same weight. The first share clears the film. Later shares must follow in
/// order and add to it. The film and its light layers are complete after the last share. Requests for `points` and `touched`
/// need all samples in one call.
RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const TraceTargets& into,
                      SampleShare share = {});

/// Traces only the blocks with a nonzero entry in `wanted`, which is indexed as in TouchedBlocks. These blocks are
/// bit-identical to those of trace_frame(). `film` must have the size of the shot. Other blocks keep their content.
RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film);

}  // namespace lippmann
