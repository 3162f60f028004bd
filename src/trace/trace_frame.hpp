// Renders one frame: every pixel's ray through the array into the scene, shaded as the DeviceScene's integrator does.
#pragma once

#include <cstdint>
#include <span>

#include "core/context.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"
#include "image/image.hpp"
#include "optics/angular_filter.hpp"
#include "optics/optics.hpp"
#include "trace/device_scene.hpp"
#include "trace/primary_points.hpp"
#include "trace/touched_blocks.hpp"

namespace lippmann {

/// In which order the pixels of a frame are traced ("pixel-tracing style" in the paper); the picture is the same.
enum class RayOrder {
  kRows,       ///< pixel row by pixel row (the paper's horizontal style)
  kColumns,    ///< column by column below each lens (the paper's vertical style)
  kViewTiles,  ///< tiles of one directional view: neighbours in a packet share one direction
};

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

struct RayCounts {
  std::uint64_t primary = 0, shadow = 0, reflection = 0, indirect = 0;  ///< reflection: mirror and refracted rays
  std::uint64_t total() const { return primary + shadow + reflection + indirect; }
};

inline void add(const RayCounts& more, RayCounts& counts) {
  counts.primary += more.primary, counts.shadow += more.shadow;
  counts.reflection += more.reflection, counts.indirect += more.indirect;
}

/// What the first hit of a pixel's centre ray (sample 0) was. Allocated to the panel's size where wanted, else empty.
struct FrameAovs {
  bool depth = false, normal = false, object_id = false, position = false;  ///< which to fill
  Image depth_image;      ///< 1 channel: z in display mm (> 0 in front of the array); -inf where nothing was hit
  Image normal_image;     ///< 3 channels: unit, world space, towards the ray; 0 where nothing was hit
  Image object_id_image;  ///< 1 channel: index in Scene::instances; -1 where nothing was hit
  Image position_image;   ///< 3 channels: world space; 0 where nothing was hit
};

/// Fills `film` (3 channels, linear, the panel's size) with the frame, and where given `points` with the first hits behind the
/// pixels' centres (free at one sample per pixel, else a pass of its own) and in `touched` the blocks whose rays meet its
/// boxes. The same bits for any number of threads. Returns early, film unfinished, when context.cancelled is set.
RayCounts trace_frame(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                      const TraceParams& params, const ThreadPool& pool, const Context& context, Image& film,
                      FrameAovs* aovs = nullptr, PrimaryPoints* points = nullptr, TouchedBlocks* touched = nullptr);

/// Traces the blocks of a frame for which `wanted` (by block, as in TouchedBlocks) is not 0, to the same bits as trace_frame;
/// `film` has the panel's size, and what lies in other blocks stays as it is.
RayCounts trace_blocks(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                       const TraceParams& params, std::span<const std::uint8_t> wanted, const ThreadPool& pool,
                       const Context& context, Image& film);

}  // namespace lippmann
