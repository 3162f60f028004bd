// Renders one frame: traces each pixel's rays through the array and shades them with the DeviceScene's integrator.
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
  int spp = 1;                                          ///< samples per pixel; stratified over the pixel's area if > 1
  int max_depth = 6;                                    ///< maximum number of path vertices; 1: no mirrors
  AngularFilter angular_filter = AngularFilter::kNone;  ///< how views are filtered; needs more than 1 sample per pixel
  ViewLens lens{};                                      ///< specified by its aperture (lens_by_aperture)
  std::uint32_t seed = 0;   ///< seed of sample positions within pixels; the same in every frame, so static parts do not flicker
  std::uint32_t frame = 0;  ///< path tracing: frame number, so that the noise differs between frames
  float clamp_indirect = 0.0f;  ///< path tracing: upper limit of an indirect contribution, which loses light; 0: no limit
};

/// The outputs of trace_frame().
struct TraceTargets {
  Image& film;                ///< resized to 3 linear channels and film_size(shot)
  FrameAovs* aovs = nullptr;  ///< light layers; path tracing only (find_first_hits, trace/first_hits.hpp, fills the others)
  /// Receives the first hits behind the pixels' centres. Free with one sample per pixel; otherwise needs an extra pass.
  PrimaryPoints* points = nullptr;
  TouchedBlocks* touched = nullptr;  ///< filled with the blocks whose rays meet its boxes
};

/// Traces a frame. The result does not depend on the number of threads. After cancellation it returns early with an unfinished
/// film. `share` selects samples; all samples have the same weight. The first share clears the film and later shares, in order,
/// add to it. The film and its light layers are complete after the last share. `points` and `touched` need all samples in one
/// call.
RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const TraceTargets& into,
                      SampleShare share = {});

/// Traces the blocks with a nonzero entry in `wanted` (indexed as in TouchedBlocks). The result is bit-identical to
/// trace_frame(). `film` must have the size of the shot; other blocks stay unchanged.
RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film);

}  // namespace lippmann
