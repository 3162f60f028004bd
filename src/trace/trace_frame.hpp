// Renders one frame: every pixel's ray through the array into the scene, shaded as the DeviceScene's integrator does.
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
  int spp = 1;                                          ///< samples per pixel; above 1 stratified over the pixel's area
  int max_depth = 6;                                    ///< path vertices: 1 = no mirrors
  AngularFilter angular_filter = AngularFilter::kNone;  ///< how views are filtered; has an effect above 1 sample per pixel
  ViewLens lens{};                                      ///< by its aperture (lens_by_aperture)
  std::uint32_t seed = 0;   ///< decides where in pixels samples lie, in every frame alike: what stands still must not flicker
  std::uint32_t frame = 0;  ///< paths: other frames have other noise
  float clamp_indirect = 0.0f;  ///< paths: > 0: no indirect contribution to a sample is brighter; loses light
};

/// What a traced frame goes into.
struct TraceTargets {
  Image& film;                       ///< becomes 3 channels, linear, as large as film_size(shot) says
  FrameAovs* aovs = nullptr;         ///< layers of light (paths only; find_first_hits, trace/first_hits.hpp, finds others)
  PrimaryPoints* points = nullptr;   ///< first hits behind the pixels' centres: free at one sample per pixel, else a pass
  TouchedBlocks* touched = nullptr;  ///< the blocks whose rays meet its boxes
};

/// Traces a frame. The same bits for any number of threads. Returns early, film unfinished, when the context is cancelled.
/// share: of the samples, all of which weigh as much; the first share clears the film, others add to it, in order, and with the
/// last the film and its layers of light are done. Points and touched blocks are of all samples only.
RayCounts trace_frame(const Shot& shot, const TraceParams& params, const Workers& workers, const TraceTargets& into,
                      SampleShare share = {});

/// Traces the blocks of a frame for which `wanted` (by block, as in TouchedBlocks) is not 0, to the same bits as trace_frame;
/// `film` has that size already, and what lies in other blocks stays as it is.
RayCounts trace_blocks(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                       const Workers& workers, Image& film);

}  // namespace lippmann
