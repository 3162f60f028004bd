// Light along random paths from the lens array into the scene, wave by wave. What all paths do stands here: camera rays, waves,
// surfaces that cover only a part, emission and surroundings, the film. What happens at a vertex, and so what ends a path, is
// its policy's, chosen at compile time.
//
//   PathIntegrator  a path goes on until chance or its depth ends it       (path_integrator.hpp)
//   FinalGather     a diffuse vertex looks up the radiance cache           (final_gather.hpp)
//   CacheUpdate     the first diffuse vertex makes a record for the cache  (cache_update.hpp)
//
// Based on: J. Kajiya, "The rendering equation", SIGGRAPH 1986; E. Veach, "Robust Monte Carlo Methods for Light Transport
// Simulation", 1997 (multiple importance sampling, the power heuristic; Russian roulette).
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "shading/bsdf_packet.hpp"
#include "shading/light_table.hpp"
#include "shading/splat_light.hpp"
#include "trace/path_film.hpp"
#include "trace/path_wave.hpp"
#include "trace/trace_frame.hpp"
#include "transport/sampler.hpp"

namespace lippmann {

/// What decides the random numbers of a frame's paths, and what becomes of them.
struct PathParams {
  int max_depth = 6;            ///< path vertices on surfaces
  std::uint32_t seed = 0;       ///< one for each frame: other frames have other noise
  float clamp_indirect = 0.0f;  ///< > 0: no indirect contribution of a path is brighter than this; loses light
  int spp = 1;                  ///< samples of a pixel: each counts 1 / spp
};
/// Where paths of a packet have met surfaces that scatter.
struct PathVertices {
  LaneMask active;
  std::array<ShadingPoint, kLanes> points;
  Lanes lengths;     ///< from the paths' starts
  BsdfPacket bsdfs;  ///< of policies that call make_bsdfs()

  const ShadingPoint& point(int i) const { return points[static_cast<std::size_t>(i)]; }
  /// For whom lights are asked for.
  LightReceiver receiver(int i) const { return {point(i).position, bsdfs.lit_side(i, point(i).normal)}; }
};

/// For paths that count as one sample each, in the frame that `trace` describes.
inline PathParams path_params(const TraceParams& trace) {
  return {trace.max_depth, hash(trace.seed, trace.frame), trace.clamp_indirect, 1};
}

/// Tracing state of one thread at a time. A Policy derives from PathTracer<Policy> and is its friend; it has
///   static constexpr bool kSeesLight    emission and surroundings that rays meet count
///   static constexpr bool kWidensBeams  behind rough surfaces, textures are filtered to a whole pixel's width
///   LaneMask begin_packet(packet, active, rays)  called with surface_ evaluated; returns the lanes that are to be shaded
///   void end_packet(packet, rays)                called after these
///   Vec2f numbers(ray, lane, pair)      random numbers of the vertex that the ray has met (kPairsPerEvent): draw(), or those
///                                       here, once draw_numbers() has been called
///   void scatter(packet, rays)          paths that have met surfaces which scatter: those of vertices_
///   void end_path(ray, radiance)        light that the ray has met
///   float chance(groups, at)            with which a vertex asks for lights of these groups rather than for others
///   float chance_of_round(k, at)        of the lamps that have a size, with which it asks for one drawn by the table's
///                                       chances; the table's own for this one where it asks for each of them
///   void trace_shadow_rays()            all that wait
/// All arguments of the constructor outlive the tracer.
template <class Policy>
class PathTracer {
 public:
  PathTracer(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film)
      : scene_(scene), beam_(beam), params_(params), film_(film), weight_(1.0f / static_cast<float>(params.spp)) {}

  /// Shades camera rays that have met the scene. What goes on from there waits for finish().
  void primary(const CameraPacket& packet) {
    alignas(64) std::uint32_t seeds[kLanes];
    const std::uint32_t seed = params_.seed;
    LIPPMANN_FOR_LANES(i) seeds[i] = hash(seed, packet.stream[i]);
    PathRay rays[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      counts_.primary += packet.active.lane[i] != 0;
      rays[i] = camera_path_ray(packet, i, seeds[i]);
    }
    shade(packet.rays, packet.active, rays);
  }

  /// Traces everything that waits, wave by wave.
  void finish() {
    policy().trace_shadow_rays();
    while (!next_.empty()) {
      std::swap(wave_, next_);
      next_.clear();
      trace_wave(scene_, wave_,
                 [this](const RayHitPacket& packet, const LaneMask& active, PathRay* rays) { shade(packet, active, rays); });
      policy().trace_shadow_rays();
    }
  }

  const RayCounts& counts() const { return counts_; }

 protected:
  const LightTable& lights() const { return *scene_.path->lights; }

  /// Draws the numbers of all lanes that have hit a surface together; the last pair is seldom asked for. rays: by lane.
  void draw_numbers(const PathRay* rays, bool with_last) {
    PathPairs paths;
    for (int i = 0; i < kLanes; ++i) {
      const bool hit = surface_.hit.lane[i] != 0;
      paths.seed[i] = hit ? rays[i].seed : 0u;
      paths.index[i] = hit ? rays[i].index : 0u;
      paths.first[i] = hit ? kPairsPerEvent * rays[i].events : 0u;
    }
    has_sky_draws_ = false;
    for (std::uint32_t p = 0; p < (with_last ? kPairsPerEvent : kPairsPerEvent - 1); ++p)
      sample_pairs(paths, p, numbers_[p].x.lane, numbers_[p].y.lane);
  }
  Vec2f numbers(const PathRay&, int i, std::uint32_t pair) const { return {numbers_[pair].x[i], numbers_[pair].y[i]}; }
  struct LanePairs {
    Lanes x, y;
  };
  const LanePairs& numbers(std::uint32_t pair) const { return numbers_[pair]; }

  /// For the same lanes, directions into the sky by their numbers for a place on a light; drawn once a packet, for who asks
  /// first.
  const SkyDraws& sky_draws() {
    if (!std::exchange(has_sky_draws_, true)) {
      LIPPMANN_FOR_LANES(i) sky_draws_.u[i] = numbers_[kOnLightPair].x[i], sky_draws_.v[i] = numbers_[kOnLightPair].y[i];
      lights().environment().sample_rest(sky_draws_);
    }
    return sky_draws_;
  }

  /// Numbers of one ray, one pair at a time.
  static Vec2f draw(const PathRay& ray, std::uint32_t pair) {
    PathSampler sampler(ray.seed, ray.index);
    sampler.jump_to(kPairsPerEvent * ray.events + pair);
    return sampler.next();
  }

  void make_bsdfs(const RayHitPacket& packet) {
    vertices_.bsdfs.clear();
    for (int i = 0; i < kLanes; ++i)
      if (vertices_.active.lane[i]) vertices_.bsdfs.set(scene_, packet, surface_, i);
    vertices_.bsdfs.prepare();
  }

  /// For each of vertices_, asks for a light, ask(lane), and if there is one calls shine(lane, light, value): what its BSDF
  /// says of the light's direction, in the lanes of `evaluated`.
  template <class Ask, class Shine>
  void ask_lights(const LaneMask& evaluated, const Ask& ask, const Shine& shine) {
    std::array<LightSample, kLanes> lights;
    Lanes3 directions{};
    LaneMask lit{}, to_evaluate{};
    for (int i = 0; i < kLanes; ++i) {
      if (!vertices_.active.lane[i]) continue;
      const std::optional<LightSample> light = ask(i);
      if (!light) continue;
      lights[static_cast<std::size_t>(i)] = *light;
      directions.set(i, light->direction);
      lit.lane[i] = -1, to_evaluate.lane[i] = evaluated.lane[i];
    }
    BsdfValueLanes values;
    if (any(to_evaluate)) vertices_.bsdfs.evaluate(to_evaluate, directions, values);
    for (int i = 0; i < kLanes; ++i)
      if (lit.lane[i]) shine(i, lights[static_cast<std::size_t>(i)], to_evaluate.lane[i] ? values.get(i) : BsdfValue{});
  }

  /// Behind the facet there is only what is transmitted, whatever the smooth normal says, and before it only what is not.
  static bool is_possible(const ShadingPoint& point, Vec3f direction, bool transmitted) {
    return point.is_behind(direction) == transmitted;
  }

  /// The same of light that is asked for: to lamps that are about to set, rays start from the smooth surface.
  static bool may_shine(const ShadingPoint& point, Vec3f direction, bool transmitted) {
    return is_possible(point, direction, transmitted) || (!transmitted && point.rises_to(direction));
  }

  /// Russian roulette: false ends the path; else its throughput makes up for those that end.
  static bool survives(Vec3f& throughput, float chance, float number) {
    if (!(number < chance)) return false;
    throughput /= chance;
    return true;
  }

  /// Sends a path on in a direction that was drawn, and counts it. Null where it carries nothing; else valid until the next.
  PathRay* go_on(const PathRay& ray, const ShadingPoint& point, Vec3f lit_side, const BsdfSample& sample, Vec3f throughput,
                 float length, std::uint64_t& count) {
    if (throughput == Vec3f(0.0f) || !is_finite(throughput)) return nullptr;
    if (!sample.is_vertex && ray.events >= kMostEvents) return nullptr;
    ++count;
    PathRay& next = next_.emplace_back(ray);
    scatter(next, point, lit_side, sample, throughput, length);
    return &next;
  }

  /// depth: vertices that have scattered it.
  void add(std::uint32_t target, Vec3f radiance, int depth) {
    const auto add_to = [&](float* film, float weight) {
      float* p = film + 3 * static_cast<std::size_t>(target);
      for (int c = 0; c < 3; ++c) p[c] += weight * radiance[c];
    };
    add_to(film_.all, weight_);
    if (float* part = depth > 1 ? film_.indirect : film_.direct) add_to(part, weight_);
    if (film_.deepest && depth >= params_.max_depth) add_to(film_.deepest, weight_);
    if (film_.seen && depth == 0) add_to(film_.seen, weight_);
    if (film_.noise) add_to(film_.noise, weight_ * noise_weight_);
  }

  const ShadedScene& scene_;
  const BeamFootprint& beam_;
  PathParams params_;
  PathFilm film_;
  float weight_;               ///< what a sample's light counts
  float noise_weight_ = 0.0f;  ///< and what it counts in film.noise, times weight_
  RayCounts counts_;
  std::vector<PathRay> next_;  ///< rays of the next wave
  SurfacePacket surface_;      ///< surfaces of the packet that is being shaded
  PathVertices vertices_;      ///< those of them that scatter

 private:
  Policy& policy() { return static_cast<Policy&>(*this); }

  /// rays: by lane; only the active lanes' count.
  void shade(const RayHitPacket& packet, LaneMask active, PathRay* rays) {
    if constexpr (Policy::kSeesLight)
      if (scene_.has_splats()) look_at_splats(packet.ray, active, rays);
    Lanes path_length;
    LaneMask spread;
    for (int i = 0; i < kLanes; ++i) {
      path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
      if constexpr (Policy::kWidensBeams) spread.lane[i] = active.lane[i] && rays[i].spread ? -1 : 0;
    }
    evaluate_surfaces(scene_, packet, active, path_length, beam_, surface_, Policy::kWidensBeams ? &spread : nullptr);
    if constexpr (Policy::kSeesLight)
      if (surface_.any_miss) look_at_sky(packet.ray);
    if constexpr (Policy::kSeesLight) look_at_round_lights(packet, active, rays);
    const LaneMask lanes = policy().begin_packet(packet, active, rays);
    vertices_.active = {};
    for (int i = 0; i < kLanes; ++i) {
      if (!lanes.lane[i]) continue;
      if (surface_.hit.lane[i])
        shade_surface(packet, i, rays[i]);
      else if constexpr (Policy::kSeesLight)
        shade_sky(packet, i, rays[i]);
    }
    if (any(vertices_.active)) policy().scatter(packet, rays);
    policy().end_packet(packet, rays);
  }

  /// The eye sees splats, and sees them in mirrors and through glass; what scatters light is not lit by them. What lies behind
  /// has the share that they let pass; lanes that nothing passes are done.
  void look_at_splats(const RayPacket& packet, LaneMask& active, PathRay* rays) {
    LaneMask looking;
    for (int i = 0; i < kLanes; ++i) looking.lane[i] = active.lane[i] && rays[i].density == kInfinity ? -1 : 0;
    SplatLight light;
    see_splats(scene_, looking, packet, splat_hits_, light);
    for (int i = 0; i < kLanes; ++i) {
      if (!looking.lane[i]) continue;
      if (const Vec3f radiance = rays[i].throughput * light.radiance.get(i); radiance != Vec3f(0.0f))
        policy().end_path(rays[i], radiance);
      rays[i].throughput *= light.passed[i];
      if (!(light.passed[i] > 0.0f)) active.lane[i] = 0;
    }
  }

  /// Rays go on through lamps that have a size.
  void look_at_round_lights(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
    if (lights().has_many_rounds()) return look_at_many_rounds(packet, active, rays);
    for (std::size_t k = 0; k < lights().rounds(); ++k) {
      if (!lights().is_pointed_at(k, packet.ray)) continue;
      for (int i = 0; i < kLanes; ++i)
        if (active.lane[i]) see_round_light(k, rays[i], packet.ray.tfar[i]);
    }
  }

  void look_at_many_rounds(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i] && sees_round_lights(rays[i]))
        lights().meet_rounds(rays[i].origin, rays[i].direction, packet.ray.tfar[i],
                             [&](std::size_t k) { see_round_light(k, rays[i], packet.ray.tfar[i]); });
  }

  /// The eye does not see lamps, rays that have scattered somewhere do.
  static bool sees_round_lights(const PathRay& ray) {
    return ray.scattered_at > 0.0f && ray.lights_from <= static_cast<std::uint16_t>(LightGroup::kRound);
  }

  /// reach: how far this part of the ray goes from its origin.
  void see_round_light(std::size_t k, const PathRay& ray, float reach) {
    if (!sees_round_lights(ray)) return;
    const float passed = ray.path_length - ray.scattered_at;
    const LightReceiver at = last_receiver(ray);
    const std::optional<LightSample> light = lights().see_round(k, at.position, ray.direction);
    if (!light || !(light->distance > passed) || !(light->distance <= passed + reach)) return;
    float share = 1.0f;
    if (ray.density != kInfinity)
      share = power_heuristic(ray.density * policy().chance_of_round(k, at), light->density * lights().chance_of_round(k, at));
    policy().end_path(ray, ray.throughput * light->radiance * share);
  }

  void look_at_sky(const RayPacket& rays) {
    LIPPMANN_FOR_LANES(i) sky_.x[i] = rays.dir_x[i], sky_.y[i] = rays.dir_y[i], sky_.z[i] = rays.dir_z[i];
    lights().environment().radiance(sky_);
  }

  void shade_sky(const RayHitPacket& packet, int i, const PathRay& ray) {
    const unsigned id = packet.hit.geomID[i];
    if (id >= kLightId && id != kNoId) {  // a bulb: surfaces ask for its light, so only mirrors and lenses see it
      if (ray.density == kInfinity) policy().end_path(ray, ray.throughput * scene_.lights[id - kLightId].color);
      return;
    }
    if (film_.open && ray.has_met_nothing()) {
      film_.open[ray.pixel] += ray.throughput.x;  // 1, or what splats have left of it
      return;
    }
    if (ray.lights_from > static_cast<std::uint16_t>(LightGroup::kSky)) return;
    float share = 1.0f;
    if (ray.density != kInfinity) {
      const LightReceiver at = last_receiver(ray);
      const LightTable::Sky sky = lights().sky(sky_, i, at);
      if (ray.lights_from > static_cast<std::uint16_t>(sky.group.begin)) return;
      share = power_heuristic(ray.density * policy().chance(sky.group, at), sky.density);
    }
    policy().end_path(ray, ray.throughput * Vec3f(sky_.red[i], sky_.green[i], sky_.blue[i]) * share);
  }

  void shade_surface(const RayHitPacket& packet, int i, PathRay& ray) {
    ShadingPoint& point = vertices_.points[static_cast<std::size_t>(i)];
    point = shading_point(scene_, surface_, i);
    const float length = ray.path_length + packet.ray.tfar[i];
    if (!(point.coverage >= 1.0f) && !(policy().numbers(ray, i, kCoveragePair).y < point.coverage)) {
      if (ray.events < kMostEvents) next_.push_back(passed(ray, point, length));
      return;
    }
    describe_first(point, i, ray);
    if constexpr (Policy::kSeesLight)
      if (point.emission != Vec3f(0.0f)) add_emission(packet, i, ray, point.emission);
    if (!point.scatters) return;
    if (ray.depth + 1 > params_.max_depth) return pass_wall(packet, i, ray, point, length);
    if (point.disperses) make_one_color(ray, i);
    vertices_.lengths[i] = length;
    vertices_.active.lane[i] = -1;
  }

  /// Paths that may have no more vertices: the last one's shadow rays pass walls, so what it has drawn does, too.
  void pass_wall(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, float length) {
    if (!Policy::kSeesLight || !point.is_wall) return;
    BsdfSample on;
    on.direction = ray.direction, on.density = kInfinity;
    on.transmitted = on.straight = true, on.is_vertex = false;
    const Vec3f straight = bsdf_at(scene_, packet, surface_, i).straight();
    go_on(ray, point, Vec3f(0.0f), on, ray.throughput * straight, length, counts_.reflection);
  }

  /// From the first surface on that disperses light, a path is one of red, green or blue light, which stands for three: else
  /// each such surface would divide it again.
  void make_one_color(PathRay& ray, int i) {
    const std::uint32_t channel = hash(ray.seed, ray.index, kColorStream) % 3;
    surface_.color_channel[i] = static_cast<std::uint8_t>(channel);
    if (ray.one_color) return;
    Vec3f throughput(0.0f);
    throughput[static_cast<int>(channel)] = 3.0f * ray.throughput[static_cast<int>(channel)];
    ray.throughput = throughput;
    ray.one_color = true;
  }

 protected:
  void describe_first(const ShadingPoint& point, int i, const PathRay& ray) {
    if (film_.surfaces && ray.has_met_nothing() && point.scatters)
      film_.surfaces->add(point, surface_.normal.get(i), ray.pixel, weight_ * ray.throughput.x);
  }

  void add_emission(const RayHitPacket& packet, int i, const PathRay& ray, Vec3f emission) {
    float share = 1.0f;
    if (ray.density != kInfinity && surface_.record[i] < kPlaneId) {
      const float distance = ray.path_length + packet.ray.tfar[i] - ray.scattered_at;
      const LightReceiver at = last_receiver(ray);
      const float density = lights().density_of(surface_.record[i], packet.hit.primID[i], distance, ray.direction, at);
      if (density > 0.0f && ray.lights_from > static_cast<std::uint16_t>(LightGroup::kLamps)) return;
      share = power_heuristic(ray.density * policy().chance(kLamps, at), density);
    }
    policy().end_path(ray, ray.throughput * emission * share);
  }

 private:
  static constexpr std::uint32_t kColorStream = 0x636f6c6fu;

  std::vector<PathRay> wave_;
  SkyRays sky_;                                    ///< by lane of the packet
  std::array<LanePairs, kPairsPerEvent> numbers_;  ///< of draw_numbers()
  SkyDraws sky_draws_;
  bool has_sky_draws_ = false;
  SplatHits splat_hits_;
};

}  // namespace lippmann
