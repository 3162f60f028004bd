// Renders one frame: every pixel's ray through the array into the scene, shaded as the DeviceScene's integrator does.
#pragma once

#include <cstdint>
#include <span>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/ray_counts.hpp"
#include "lippmann/trace/ray_order.hpp"
#include "trace/device_scene.hpp"
#include "trace/primary_points.hpp"
#include "trace/touched_blocks.hpp"

namespace lippmann {

struct TraceParams {
  RayOrder order = RayOrder::kViewTiles;
  int spp = 1;                                          ///< samples per pixel; above 1 stratified over the pixel's area
  int max_depth = 6;                                    ///< path vertices: 1 = no mirrors
  AngularFilter angular_filter = AngularFilter::kNone;  ///< of views; above 1 sample per pixel
  std::uint32_t seed =
      0;  ///< of the sub-pixel positions, which are the same in every frame: what stands still must not flicker
  std::uint32_t frame = 0;      ///< paths: other frames have other noise
  float clamp_indirect = 0.0f;  ///< paths: > 0: no indirect contribution to a sample is brighter; loses light
};

/// Fills `film` (3 channels, linear, the panel's size) with the frame, and where given: of `aovs` the layers of light (paths
/// only; others are found by find_first_hits, trace/first_hits.hpp), `points` with the first hits behind the pixels' centres
/// (free at one sample per pixel, else a pass of its own) and in `touched` the blocks whose rays meet its boxes. The same bits
/// for any number of threads. Returns early, film unfinished, when context.cancelled is set.
RayCounts trace_frame(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                      const TraceParams& params, const ThreadPool& pool, const Context& context, Image& film,
                      FrameAovs* aovs = nullptr, PrimaryPoints* points = nullptr, TouchedBlocks* touched = nullptr);

/// Traces the blocks of a frame for which `wanted` (by block, as in TouchedBlocks) is not 0, to the same bits as trace_frame;
/// `film` has the panel's size, and what lies in other blocks stays as it is.
RayCounts trace_blocks(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                       const TraceParams& params, std::span<const std::uint8_t> wanted, const ThreadPool& pool,
                       const Context& context, Image& film);

}  // namespace lippmann
