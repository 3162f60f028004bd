#include "trace/trace_pixels.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "trace/packet_source.hpp"
#include "trace/path_tracer.hpp"
#include "trace/scene_query.hpp"
#include "trace/whitted.hpp"

namespace lippmann {
namespace {

using Pixels = std::span<const std::uint32_t>;

/// The position in the ray order of every pixel of a full strip, by y * width + x.
std::vector<std::uint32_t> ranks_in_strip(const StripOrder& order, int width) {
  std::vector<std::uint32_t> ranks(order.pixels.size());
  for (std::uint32_t i = 0; i < order.pixels.size(); ++i)
    ranks[static_cast<std::size_t>(order.pixels[i].y) * static_cast<std::size_t>(width) + order.pixels[i].x] = i;
  return ranks;
}

/// The pixels sorted by strip and, within it, as the ray order has them; strip s is [begin[s], begin[s + 1]).
struct OrderedPixels {
  std::vector<std::uint32_t> pixels;
  std::vector<std::size_t> begin;
};

OrderedPixels in_ray_order(Pixels pixels, const Optics& optics, RayOrder ray_order) {
  const StripOrder order = make_strip_order(optics, ray_order);
  const std::vector<std::uint32_t> ranks = ranks_in_strip(order, optics.panel.width);
  const auto strip_pixels = static_cast<std::uint32_t>(ranks.size());
  OrderedPixels ordered{{pixels.begin(), pixels.end()}, {0}};
  std::size_t end = 0;
  for (std::uint32_t strip = 0; end < pixels.size(); ++strip) {
    const std::uint64_t first_of_next = (strip + std::uint64_t{1}) * strip_pixels;
    while (end < pixels.size() && pixels[end] < first_of_next) ++end;
    const auto from = ordered.pixels.begin() + static_cast<std::ptrdiff_t>(ordered.begin.back());
    std::sort(from, ordered.pixels.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
      return ranks[a - strip * strip_pixels] < ranks[b - strip * strip_pixels];
    });
    ordered.begin.push_back(end);
  }
  return ordered;
}

/// Makes primary packets of up to 16 given pixels.
class PixelPackets {
 public:
  PixelPackets(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel)
      : centre_(optics, world_from_display),
        rays_(optics, world_from_display, sub_pixel),
        width_(static_cast<std::uint32_t>(optics.panel.width)) {}

  /// 1 to 16 pixels; lanes beyond them get the last one's ray and are inactive.
  void fill(Pixels pixels, const SubPixel& sub_pixel, int sample, RayPacket& rays, LaneMask& active,
            std::uint32_t* pixel) const {
    alignas(64) float px[kLanes], py[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
      pixel[i] = pixels[std::min(i, pixels.size() - 1)];
      active.lane[i] = i < pixels.size() ? -1 : 0;
      px[i] = static_cast<float>(pixel[i] % width_) + 0.5f;
      py[i] = static_cast<float>(pixel[i] / width_) + 0.5f;
      if (sub_pixel.samples == 1) continue;
      const Vec2f offset = sub_pixel.position(pixel[i], sample) - Vec2f(0.5f);
      px[i] += offset.x, py[i] += offset.y;
    }
    const RayGenerator& generator = sub_pixel.samples == 1 ? centre_ : rays_.of(sample);
    generator.rays(px, py, kLanes, {rays.org_x, rays.org_y, rays.org_z, rays.dir_x, rays.dir_y, rays.dir_z});
    const Vec3f forward = generator.forward();
    for (int i = 0; i < kLanes; ++i) {
      rays.tnear[i] = 0.0f;
      rays.tfar[i] = generator.depth() / (rays.dir_x[i] * forward.x + rays.dir_y[i] * forward.y + rays.dir_z[i] * forward.z);
    }
  }

 private:
  RayGenerator centre_;
  SampleRays rays_;
  std::uint32_t width_;
};

Pixels packet_of(Pixels pixels, std::size_t packet) {
  const std::size_t first = packet * kLanes;
  return pixels.subspan(first, std::min<std::size_t>(kLanes, pixels.size() - first));
}

std::size_t packets_in(Pixels pixels) { return (pixels.size() + kLanes - 1) / kLanes; }

template <class Tracer>
void trace_strip(const PixelPackets& packets, Pixels pixels, const SubPixel& sub_pixel, Tracer& tracer) {
  const float weight = 1.0f / static_cast<float>(sub_pixel.samples);
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  const std::size_t count = packets_in(pixels);
  for (std::size_t first = 0; first < count; first += kPacketsPerBlock)
    for (int sample = 0; sample < sub_pixel.samples; ++sample) {
      if constexpr (std::is_same_v<Tracer, PathTracer>) tracer.begin_sample(sample);
      for (std::size_t p = first; p < std::min(count, first + kPacketsPerBlock); ++p) {
        packets.fill(packet_of(pixels, p), sub_pixel, sample, packet.ray, active, pixel);
        tracer.primary(packet, active, pixel, weight);
      }
      tracer.finish_batch();
    }
}

void capture_strip(const PixelPackets& packets, Pixels pixels, const DeviceScene::Impl& scene, const PointCapture& capture) {
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  for (std::size_t p = 0; p < packets_in(pixels); ++p) {
    packets.fill(packet_of(pixels, p), SubPixel{}, 0, packet.ray, active, pixel);
    clear_hits(packet);
    intersect_scene(scene, active, packet, Coherence::kCoherent);
    capture.store(packet, active, pixel);
  }
}

RayCounts sum(const std::vector<RayCounts>& counts) {
  RayCounts total;
  for (const RayCounts& c : counts) add(c, total);
  return total;
}

}  // namespace

RayCounts trace_pixels(const Shot& shot, const TraceParams& params, Pixels pixels, const Workers& workers, Image& film,
                       PrimaryPoints* points) {
  if (pixels.empty()) return {};
  const DeviceScene::Impl& scene = shot.device.impl();
  const Optics& optics = shot.optics;
  const Affine3f& world_from_display = shot.world_from_display;
  const OrderedPixels ordered = in_ray_order(pixels, optics, params.order);
  const BeamFootprint beam(optics, world_from_display, params.spp);
  const SubPixel sub_pixel{params.seed, params.spp, params.angular_filter};
  const PixelPackets packets(optics, world_from_display, sub_pixel);
  std::optional<PointCapture> capture;
  if (points) capture.emplace(scene, inverse(world_from_display), *points);
  const bool along = capture && params.spp == 1 && !scene.path;
  std::vector<RayCounts> counts(ordered.begin.size() - 1);
  workers.pool.for_each(counts.size(), [&](std::size_t strip) {
    const std::size_t first = ordered.begin[strip];
    const Pixels of_strip = Pixels(ordered.pixels).subspan(first, ordered.begin[strip + 1] - first);
    if (of_strip.empty() || workers.context.cancelled) return;
    for (const std::uint32_t pixel : of_strip) std::fill_n(film.data.begin() + 3 * static_cast<std::ptrdiff_t>(pixel), 3, 0.0f);
    if (scene.path) {
      PathFilm light;
      light.all = film.data.data();
      PathTracer tracer(scene, beam, path_params(params), light);
      trace_strip(packets, of_strip, sub_pixel, tracer);
      counts[strip] = tracer.counts();
    } else {
      WhittedTracer tracer(scene, beam, params.max_depth, film);
      tracer.capture_to(along ? &*capture : nullptr);
      trace_strip(packets, of_strip, sub_pixel, tracer);
      counts[strip] = tracer.counts();
    }
    if (capture && !along) capture_strip(packets, of_strip, scene, *capture);
  });
  return sum(counts);
}

}  // namespace lippmann
