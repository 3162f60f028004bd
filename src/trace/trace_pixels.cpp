#include "trace/trace_pixels.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "trace/frame_work.hpp"
#include "trace/integrator_model.hpp"
#include "trace/trace_batch.hpp"

namespace lippmann {
namespace {

using Pixels = std::span<const std::uint32_t>;

std::vector<std::uint32_t> ranks_in_strip(const StripOrder& order, int width) {
  std::vector<std::uint32_t> ranks(order.pixels.size());
  for (std::uint32_t i = 0; i < order.pixels.size(); ++i)
    ranks[static_cast<std::size_t>(order.pixels[i].y) * static_cast<std::size_t>(width) + order.pixels[i].x] = i;
  return ranks;
}

/// Pixels sorted in tracing order. Those of strip s are pixels[begin[s]] to pixels[begin[s + 1] - 1].
struct OrderedPixels {
  std::vector<std::uint32_t> pixels;
  std::vector<std::size_t> begin;
};

OrderedPixels in_ray_order(Pixels pixels, const Optics& optics, RayOrder ray_order) {
  const StripOrder order = make_strip_order(optics, ray_order);
  const std::vector<std::uint32_t> ranks = ranks_in_strip(order, film_size(optics).x);
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

struct PixelRays {
  PixelRays(const Shot& shot, const SubPixel& where)
      : sub_pixel(where),
        samples(shot.optics, shot.world_from_display, where),
        width(static_cast<std::uint32_t>(film_size(shot).x)),
        first_pixel(lippmann::first_pixel(shot.optics, shot.rows)) {}

  SubPixel sub_pixel;
  SampleRays samples;
  std::uint32_t width;
  std::uint32_t first_pixel;
};

struct PixelPackets {
  const PixelRays& from;
  Pixels pixels;

  /// Lanes beyond the last pixel are inactive and repeat the last pixel's ray.
  bool fill(int packet, int sample, CameraPacket& into) const {
    const auto first = static_cast<std::size_t>(packet) * kLanes;
    const SubPixel& sub_pixel = from.sub_pixel;
    alignas(64) float px[kLanes], py[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::uint32_t of_rows = pixels[std::min(first + i, pixels.size() - 1)];
      const std::uint32_t pixel = from.first_pixel + of_rows;
      into.target[i] = of_rows;
      into.stream[i] = pixel, into.sample[i] = static_cast<std::uint32_t>(sample);
      into.active.lane[i] = first + i < pixels.size() ? -1 : 0;
      px[i] = static_cast<float>(pixel % from.width) + 0.5f;
      py[i] = static_cast<float>(pixel / from.width) + 0.5f;
      if (sub_pixel.samples == 1) continue;
      const Vec2f offset = sub_pixel.position(pixel, sample) - Vec2f(0.5f);
      px[i] += offset.x, py[i] += offset.y;
    }
    from.samples.fill(sample, px, py, into.stream, into.rays.ray);
    return true;
  }
};

}  // namespace

RayCounts trace_pixels(const Shot& shot, const TraceParams& params, Pixels pixels, const Workers& workers, Image& film,
                       PrimaryPoints* points, float* open) {
  if (pixels.empty()) return {};
  const ShadedScene& scene = shot.device.shaded();
  const OrderedPixels ordered = in_ray_order(pixels, shot.optics, params.order);
  const BeamFootprint beam(shot.optics, shot.world_from_display, params.spp);
  const PixelRays samples(shot, {params.seed, params.spp, params.angular_filter, params.lens});
  const PixelRays centres(shot, {});
  std::optional<PointCapture> capture;
  if (points) capture.emplace(scene, inverse(shot.world_from_display), *points);
  const bool along = capture && params.spp == 1;
  const auto trace = [&](const PixelPackets& packets, int spp, auto& integrator, const PacketSinks& sinks) {
    for_each_batch({}, 0, static_cast<int>(packets_of(packets.pixels.size())), [&](std::span<const int> batch, std::size_t) {
      if (workers.context.cancelled) return;
      trace_batch(scene, packets, {batch, 0, spp}, integrator, sinks);
    });
  };
  const PathFilm light{.all = film.data.data(), .open = open};
  return trace_strips(ordered.begin.size() - 1, workers.silent(), [&](std::size_t strip) {
    const std::size_t first = ordered.begin[strip];
    const Pixels of_strip = Pixels(ordered.pixels).subspan(first, ordered.begin[strip + 1] - first);
    const auto integrator = shot.device.integrator().model().make({scene, beam, params, light});
    trace({samples, of_strip}, params.spp, *integrator, {&film, along ? &*capture : nullptr});
    NoIntegrator none;
    if (capture && !along) trace({centres, of_strip}, 1, none, {nullptr, &*capture});
    return integrator->counts();
  });
}

}  // namespace lippmann
