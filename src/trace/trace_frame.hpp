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
  int spp = 1;
  int max_depth = 6;  ///< maximum number of vertices of a path; 1: no mirrors
  /// Filter of a view's pixels over directions; needs more than 1 sample per pixel.
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};  ///< needs an aperture in mm instead of an f-number; see lens_by_aperture()
  /// Seed of sample positions; constant over frames, so that static parts do not flicker.
  std::uint32_t seed = 0;
  std::uint32_t frame = 0;  ///< path tracing only: number of the frame, which makes the noise of frames different
  /// Path tracing only: upper limit of one path's indirect light; 0: no limit. A limit reduces noise, but darkens images.
  float clamp_indirect = 0.0f;
};

struct TraceTargets {
  Image& film;  ///< resized to film_size(shot), with 3 linear channels
  /// Receives direct light, indirect light and alpha (path tracing only). find_first_hits() fills the other layers.
  FrameAovs* aovs = nullptr;
  /// Receives the first hit of the ray through each pixel's centre; may be null.
  PrimaryPoints* points = nullptr;
  TouchedBlocks* touched = nullptr;
};

/// Traces a frame. After cancellation, returns early with an unfinished film. `share` selects a subset of the samples: the
/// first subset clears the film, and the following ones must come in order and add to it. If `into.points` or `into.touched`
/// is set, one call must take all samples.
RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const TraceTargets& into,
                      SampleShare share = {});

/// Traces only the blocks with a nonzero entry in `wanted`; TouchedBlocks explains blocks. Their pixels are bit-identical to
/// those of trace_frame(). `film` must have the size of the shot. Other blocks keep their content.
RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film);

}  // namespace lippmann
