// Measures the rays per second of primary rays and of whole Whitted frames, relative to a bare Embree loop over the
// same rays, which copies a prepared packet, traces it and keeps the hits in registers. A row states the median ratio
// of the bare loop's time to our time.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/benchmarks.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "device/embree_scene.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"
#include "trace/trace_batch.hpp"
#include "trace/whitted.hpp"

namespace lippmann::bench {
namespace {

constexpr int kRaysRepetitions = 7;

struct LoggedStrip {
  StripPackets packets;
  RayLog* log = nullptr;

  bool fill(int packet, int sample, CameraPacket& into) const {
    if (!packets.fill(packet, sample, into)) return false;
    if (log) log->push_back(logged(into.rays.ray, into.active, Coherence::kCoherent));
    return true;
  }
};

template <class Integrator>
void trace_strip(const ShadedScene& scene, const LoggedStrip& strip, Integrator& integrator) {
  for_each_batch({}, 0, strip.packets.source.packets_per_strip(),
                 [&](std::span<const int> batch, std::size_t) { trace_batch(scene, strip, {batch}, integrator); });
}

LIPPMANN_MULTIVERSION void store_hits(const RayHitPacket& packet, float* t, float* u, float* v, std::uint32_t* geometry,
                                      std::uint32_t* primitive) {
  LIPPMANN_FOR_LANES(i) {
    const unsigned placed = packet.hit.instID[0][i];
    t[i] = packet.ray.tfar[i];
    u[i] = packet.hit.u[i], v[i] = packet.hit.v[i];
    geometry[i] = placed != kNoId ? placed : packet.hit.geomID[i];
    primitive[i] = packet.hit.primID[i];
  }
}

/// Stores the hits of camera rays packet by packet. For a lane without a hit, t is the end of the ray.
class StoredHits {
 public:
  explicit StoredHits(const PacketSource& source) {
    const auto lanes = static_cast<std::size_t>(source.packets_per_strip()) * kLanes;
    t.resize(lanes), u_.resize(lanes), v_.resize(lanes), geometry_.resize(lanes), primitive_.resize(lanes);
  }

  void clear() { at_ = 0; }
  void primary(const CameraPacket& packet) {
    store_hits(packet.rays, &t[at_], &u_[at_], &v_[at_], &geometry_[at_], &primitive_[at_]);
    at_ += kLanes;
  }
  void finish() {}

  std::vector<float> t;

 private:
  std::size_t at_ = 0;
  std::vector<float> u_, v_;
  std::vector<std::uint32_t> geometry_, primitive_;
};

/// Returns a sum over the results, so that the compiler cannot remove the work.
double trace_bare(const RayScene& rays, const RayLog& log) {
  const RayScene::Embree& scene = rays.embree();
  RayHitPacket packet;
  ShadowContext context;
  context.geometry = &rays;
  for (float& t : context.transmittance) t = 1.0f;
  double sum = 0.0;
  for (const LoggedPacket& logged : log) {
    packet.ray = logged.rays;
    if (logged.shadow) {
      if (scene.has_fixed) occluded(scene.fixed.get(), scene.native_width, logged.active, packet.ray, context);
      if (scene.has_moving) occluded(scene.moving.get(), scene.native_width, logged.active, packet.ray, context);
    } else {
      std::fill_n(packet.hit.geomID, kLanes, kNoId);
      std::fill_n(packet.hit.instID[0], kLanes, kNoId);
      if (scene.has_fixed) intersect(scene.fixed.get(), scene.native_width, logged.active, packet, logged.coherence);
      if (scene.has_moving) intersect(scene.moving.get(), scene.native_width, logged.active, packet, logged.coherence);
    }
    sum += packet.ray.tfar[0];
  }
  return sum;
}

struct Times {
  double bare_primary = 0, primary = 0, bare_all = 0, whitted = 0;
};

struct MeasuredRays {
  std::uint64_t primary_rays = 0, all_rays = 0;
  Times median_times;
  double primary_ratio = 0, whitted_ratio = 0;
};

class RayBench {
 public:
  RayBench(const Stage& stage, const Affine3f& world_from_display, RayOrder order)
      : scene_(stage.device.shaded()),
        source_(stage.placed.optics, world_from_display, order, SubPixel{}),
        beam_(stage.placed.optics, world_from_display),
        max_depth_(stage.scene.max_depth),
        film_(film_size(stage.placed.optics).x, film_size(stage.placed.optics).y, 3),
        hits_(source_) {}

  MeasuredRays measure() {
    MeasuredRays result;
    std::vector<double> primary_ratios, whitted_ratios;
    std::vector<Times> all;
    for (int repetition = -1; repetition < kRaysRepetitions; ++repetition) {
      Times times;
      result.primary_rays = result.all_rays = 0;
      for (int strip = 0; strip < source_.strips(); ++strip) measure_strip(strip, times, result);
      if (repetition < 0) continue;
      all.push_back(times);
      primary_ratios.push_back(times.bare_primary / times.primary);
      whitted_ratios.push_back(times.bare_all / times.whitted);
    }
    const auto middle = [&](double Times::*field) {
      std::vector<double> values;
      for (const Times& t : all) values.push_back(t.*field);
      return median(values);
    };
    result.median_times = {middle(&Times::bare_primary), middle(&Times::primary), middle(&Times::bare_all),
                           middle(&Times::whitted)};
    result.primary_ratio = median(primary_ratios);
    result.whitted_ratio = median(whitted_ratios);
    return result;
  }

  void check() {
    const int strip = source_.strips() / 2;
    log_.clear(), hits_.clear();
    trace_strip(scene_, {{source_, strip}, &log_}, hits_);
    for (std::size_t p = 0; p < log_.size(); ++p) {
      RayHitPacket packet;
      packet.ray = log_[p].rays;
      scene_.trace(log_[p].active, packet, Coherence::kCoherent);
      for (int i = 0; i < kLanes; ++i)
        if (log_[p].active.lane[i] && packet.ray.tfar[i] != hits_.t[p * kLanes + static_cast<std::size_t>(i)])
          throw Error("rays", "the primary pass and the bare loop disagree in packet " + std::to_string(p));
    }
  }

 private:
  void measure_strip(int strip, Times& times, MeasuredRays& result) {
    const LoggedStrip packets{{source_, strip}};
    WhittedTracer tracer(scene_, beam_, {max_depth_}, {.all = film_.data.data()});
    log_.clear();
    tracer.log_to(&log_);
    trace_strip(scene_, {packets.packets, &log_}, tracer);
    result.all_rays += tracer.counts().total();
    result.primary_rays += tracer.counts().primary;
    primaries_.clear();
    for (const LoggedPacket& packet : log_)
      if (!packet.shadow && packet.coherence == Coherence::kCoherent) primaries_.push_back(packet);
    // Our code and the bare loop each run twice, and only the second run is timed, so that caches and branch predictors are
    // warm.
    WhittedTracer timed(scene_, beam_, {max_depth_}, {.all = film_.data.data()});
    times.whitted += second_run([&] { trace_strip(scene_, packets, timed); });
    times.bare_all += second_run([&] { sink_ = sink_ + trace_bare(scene_, log_); });
    times.primary += second_run([&] {
      hits_.clear();
      trace_strip(scene_, packets, hits_);
    });
    times.bare_primary += second_run([&] { sink_ = sink_ + trace_bare(scene_, primaries_); });
  }

  const ShadedScene& scene_;
  PacketSource source_;
  BeamFootprint beam_;
  int max_depth_;
  Image film_;
  RayLog log_, primaries_;
  StoredHits hits_;
  volatile double sink_ = 0;
};

}  // namespace

Report measure_rays(const Request& request, const Context& context) {
  Report report;
  const ThreadPool pool(1);
  pool.run([&] {
    for (const BenchScene& setup : bench_scenes(request, context)) {
      JobStage stage(ResolvedJob(setup.params), pool, context);
      const ResolvedScene resolved = evaluate(stage.scene, stage.scene.timeline.time(setup.frame));
      stage.device.update(resolved, pool);
      const Affine3f world_from_array = world_from_display(stage.array, stage.placed.units_per_mm, resolved);
      for (const RayOrder order : {RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles}) {
        begin_step(request, context, fmt::format("rays: {}, {}", setup.name, to_string(order)));
        RayBench bench(stage, world_from_array, order);
        bench.check();
        ++report.passed_checks;
        const MeasuredRays m = bench.measure();
        report.rows.push_back(
            {{"scene", setup.name},
             {"order", to_string(order)},
             {"bare_mrays_s", rounded(1e-6 * static_cast<double>(m.primary_rays) / m.median_times.bare_primary)},
             {"primary_mrays_s", rounded(1e-6 * static_cast<double>(m.primary_rays) / m.median_times.primary)},
             {"primary_ratio", rounded(m.primary_ratio)},
             {"whitted_ratio", rounded(m.whitted_ratio)},
             {"whitted_mrays_s", rounded(1e-6 * static_cast<double>(m.all_rays) / m.median_times.whitted)},
             {"whitted_ms", rounded(1e3 * m.median_times.whitted)}});
      }
    }
  });
  return report;
}

}  // namespace lippmann::bench
