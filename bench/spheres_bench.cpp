// Compares two ways to trace spheres: our user geometry, which tests whole packets of rays, and Embree's
// RTC_GEOMETRY_TYPE_SPHERE_POINT. Only the calls of Embree are timed.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/benchmarks.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "device/embree_scene.hpp"
#include "device/user_geometry.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"
#include "shading/shaded_scene.hpp"
#include "trace/packet_source.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSpheresRepetitions = 9;

struct LogEntry {
  RayPacket rays;
  LaneMask active;
};
using Packets = std::vector<LogEntry>;

PrimitiveTable<WorldSphere> world_spheres(const Scene& scene, const ResolvedScene& resolved) {
  PrimitiveTable<WorldSphere> table;
  for (const Instance& instance : scene.instances)
    if (const auto* spheres = std::get_if<Spheres>(&scene.shapes[static_cast<std::size_t>(instance.shape)]))
      for (const Sphere& sphere : *spheres) table.primitives.push_back(to_world(resolved.of(instance.node), sphere));
  return table;
}

EmbreeScene commit(RTCDevice device, const EmbreeGeometry& geometry) {
  EmbreeScene scene(rtcNewScene(device));
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

EmbreeScene scene_of_points(RTCDevice device, const std::vector<WorldSphere>& spheres) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT));
  auto* vertices = static_cast<WorldSphere*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                     RTC_FORMAT_FLOAT4, sizeof(WorldSphere), spheres.size()));
  std::copy(spheres.begin(), spheres.end(), vertices);
  rtcCommitGeometry(geometry.get());
  return commit(device, geometry);
}

std::vector<float> distances(const EmbreeScene& scene, int native_width, const Packets& packets) {
  std::vector<float> result;
  result.reserve(packets.size() * kLanes);
  RayHitPacket packet;
  for (const LogEntry& entry : packets) {
    packet.ray = entry.rays;
    clear_hits(packet);
    intersect(scene.get(), native_width, entry.active, packet, Coherence::kCoherent);
    for (int i = 0; i < kLanes; ++i)
      result.push_back(entry.active.lane[i] && packet.hit.primID[i] != kNoId ? packet.ray.tfar[i] : 0.0f);
  }
  return result;
}

/// The packets of a strip are prepared before they are timed, so that they are in the cache.
double seconds_to_trace(const EmbreeScene& scene, int native_width, const Packets& packets) {
  constexpr std::size_t kStrip = 256;
  std::vector<RayHitPacket> ready(kStrip);
  double total = 0.0;
  for (std::size_t first = 0; first < packets.size(); first += kStrip) {
    const std::size_t count = std::min(kStrip, packets.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      ready[i].ray = packets[first + i].rays;
      clear_hits(ready[i]);
    }
    total += seconds([&] {
      for (std::size_t i = 0; i < count; ++i)
        intersect(scene.get(), native_width, packets[first + i].active, ready[i], Coherence::kCoherent);
    });
  }
  return total;
}

void check(const std::vector<float>& ours, const std::vector<float>& theirs) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (std::abs(ours[i] - theirs[i]) > 1e-3f * std::abs(theirs[i])) ++different;
  if (different * 1000 > ours.size())
    throw Error("spheres", std::to_string(different) + " of " + std::to_string(ours.size()) + " rays disagree");
}

}  // namespace

Report measure_spheres(const Request& request, const Context& context) {
  Report report;
  Request wanted = request;
  if (wanted.scenes.empty()) wanted.scenes = {"small-balls"};
  const ThreadPool pool(1);
  pool.run([&] {
    for (const BenchScene& setup : bench_scenes(wanted, context)) {
      begin_step(request, context, fmt::format("spheres: {}", setup.name));
      JobStage stage(ResolvedJob(setup.params), pool, context);
      const ResolvedScene resolved = evaluate(stage.scene, stage.scene.timeline.time(setup.frame));
      PrimitiveTable<WorldSphere> table = world_spheres(stage.scene, resolved);
      if (table.primitives.empty()) throw Error(setup.name, "it has no spheres", "a scene with spheres, such as small-balls");
      const RayScene::Embree& embree = stage.device.shaded().embree();
      const EmbreeScene ours = commit(embree.device.get(), make_user_geometry(embree.device.get(), table));
      const EmbreeScene theirs = scene_of_points(embree.device.get(), table.primitives);

      const PacketSource source(stage.placed.optics, world_from_display(stage.array, stage.placed.units_per_mm, resolved),
                                setup.params.sampling.order, SubPixel{});
      Packets packets;
      LogEntry entry;
      alignas(64) std::uint32_t pixel[kLanes];
      std::uint64_t rays = 0;
      for (int strip = 0; strip < source.strips(); ++strip)
        for (int p = 0; p < source.packets_per_strip(); ++p)
          if (const int count = source.fill(strip, p, 0, entry.rays, entry.active, pixel); count > 0) {
            packets.push_back(entry);
            rays += static_cast<std::uint64_t>(count);
          }
      check(distances(ours, embree.native_width, packets), distances(theirs, embree.native_width, packets));
      ++report.passed_checks;

      std::vector<double> our_times, their_times, ratios;
      for (int repetition = 0; repetition < kSpheresRepetitions; ++repetition) {
        our_times.push_back(seconds_to_trace(ours, embree.native_width, packets));
        their_times.push_back(seconds_to_trace(theirs, embree.native_width, packets));
        ratios.push_back(their_times.back() / our_times.back());
      }
      const double mrays = 1e-6 * static_cast<double>(rays);
      report.rows.push_back({{"scene", setup.name},
                             {"spheres", table.primitives.size()},
                             {"mrays_s", rounded(mrays / median(our_times))},
                             {"sphere_point_mrays_s", rounded(mrays / median(their_times))},
                             {"ratio", rounded(median(ratios))}});
    }
  });
  return report;
}

}  // namespace lippmann::bench
