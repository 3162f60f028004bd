#include "trace/trace_frame.hpp"

#include <optional>

#include "core/error.hpp"
#include "trace/packet_source.hpp"
#include "trace/scene_query.hpp"
#include "trace/whitted.hpp"

namespace lippmann {
namespace {

// Packets shaded before their mirror rays are traced: enough to fill the next wave's packets, few enough to stay in cache.
constexpr int kBatchPackets = 64;

RayCounts trace_strip(const PacketSource& source, const DeviceScene::Impl& scene, const BeamFootprint& beam,
                      const TraceParams& params, int strip, Image& film, const PointCapture* capture) {
  WhittedTracer tracer(scene, beam, params.max_depth, film);
  tracer.capture_to(capture);
  const float weight = 1.0f / static_cast<float>(params.spp);
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  for (int first = 0; first < source.packets_per_strip(); first += kBatchPackets) {
    const int end = std::min(first + kBatchPackets, source.packets_per_strip());
    for (int sample = 0; sample < params.spp; ++sample) {
      for (int p = first; p < end; ++p)
        if (source.fill(strip, p, sample, packet.ray, active, pixel) > 0) tracer.primary(packet, active, pixel, weight);
      tracer.finish_batch();
    }
  }
  return tracer.counts();
}

void allocate(Image& image, bool wanted, const Panel& panel, int channels, float value) {
  image = wanted ? Image(panel.width, panel.height, channels) : Image();
  std::fill(image.data.begin(), image.data.end(), value);
}

/// The first hit behind every pixel's centre.
void fill_aovs_of_strip(const PacketSource& source, const DeviceScene::Impl& scene, const Affine3f& display_from_world,
                        int strip, FrameAovs& aovs) {
  RayHitPacket packet;
  LaneMask active;
  SurfacePacket surface;
  alignas(64) std::uint32_t pixel[kLanes];
  for (int p = 0; p < source.packets_per_strip(); ++p) {
    if (source.fill(strip, p, 0, packet.ray, active, pixel) == 0) continue;
    clear_hits(packet);
    intersect_scene(scene, active, packet, Coherence::kCoherent);
    evaluate_geometry(scene, packet, active, surface);
    if (!surface.any_hit) continue;
    for (int i = 0; i < kLanes; ++i) {
      if (!surface.hit.lane[i]) continue;
      const std::size_t at = pixel[i];
      const Vec3f position = surface.position.get(i), normal = surface.normal.get(i);
      if (aovs.depth) aovs.depth_image.data[at] = transform_point(display_from_world, position).z;
      if (aovs.object_id) aovs.object_id_image.data[at] = static_cast<float>(surface.instance[i]);
      for (int c = 0; c < 3; ++c) {
        if (aovs.normal) aovs.normal_image.data[3 * at + static_cast<std::size_t>(c)] = normal[c];
        if (aovs.position) aovs.position_image.data[3 * at + static_cast<std::size_t>(c)] = position[c];
      }
    }
  }
}

void fill_aovs(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display, RayOrder order,
               const ThreadPool& pool, FrameAovs& aovs) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  allocate(aovs.depth_image, aovs.depth, optics.panel, 1, -kInfinity);
  allocate(aovs.normal_image, aovs.normal, optics.panel, 3, 0.0f);
  allocate(aovs.object_id_image, aovs.object_id, optics.panel, 1, -1.0f);
  allocate(aovs.position_image, aovs.position, optics.panel, 3, 0.0f);
  const Affine3f display_from_world = inverse(world_from_display);
  pool.for_each(static_cast<std::size_t>(source.strips()), [&](std::size_t strip) {
    fill_aovs_of_strip(source, scene.impl(), display_from_world, static_cast<int>(strip), aovs);
  });
}

/// The first hits behind the centres of pixels whose samples lie elsewhere.
void capture_points(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display, RayOrder order,
                    const ThreadPool& pool, const PointCapture& capture) {
  const PacketSource source(optics, world_from_display, order, SubPixel{});
  pool.for_each(static_cast<std::size_t>(source.strips()), [&](std::size_t strip) {
    RayHitPacket packet;
    LaneMask active;
    alignas(64) std::uint32_t pixel[kLanes];
    for (int p = 0; p < source.packets_per_strip(); ++p) {
      if (source.fill(static_cast<int>(strip), p, 0, packet.ray, active, pixel) == 0) continue;
      clear_hits(packet);
      intersect_scene(scene.impl(), active, packet, Coherence::kCoherent);
      capture.store(packet, active, pixel);
    }
  });
}

}  // namespace

RayCounts trace_frame(const DeviceScene& scene, const Optics& optics, const Affine3f& world_from_display,
                      const TraceParams& params, const ThreadPool& pool, const Context& context, Image& film, FrameAovs* aovs,
                      PrimaryPoints* points) {
  film.width = optics.panel.width, film.height = optics.panel.height, film.channels = 3;
  film.data.assign(3 * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height), 0.0f);
  const BeamFootprint beam(optics, world_from_display);
  const SubPixel sub_pixel{params.seed, static_cast<std::uint32_t>(params.frame), params.spp};
  const PacketSource source(optics, world_from_display, params.order, sub_pixel);
  std::optional<PointCapture> capture;
  if (points) {
    points->resize(static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
    capture.emplace(scene.impl(), inverse(world_from_display), *points);
  }
  const PointCapture* along = params.spp == 1 && capture ? &*capture : nullptr;
  std::vector<RayCounts> counts(static_cast<std::size_t>(source.strips()));
  pool.for_each(counts.size(), [&](std::size_t strip) {
    if (context.cancelled) return;
    counts[strip] = trace_strip(source, scene.impl(), beam, params, static_cast<int>(strip), film, along);
  });
  if (capture && !along) capture_points(scene, optics, world_from_display, params.order, pool, *capture);
  if (aovs && (aovs->depth || aovs->normal || aovs->object_id || aovs->position))
    fill_aovs(scene, optics, world_from_display, params.order, pool, *aovs);
  RayCounts total;
  for (const RayCounts& c : counts) {
    total.primary += c.primary, total.shadow += c.shadow;
    total.reflection += c.reflection, total.indirect += c.indirect;
  }
  return total;
}

}  // namespace lippmann
