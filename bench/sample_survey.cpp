#include "bench/sample_survey.hpp"

#include "trace/path_tracer.hpp"
#include "trace/shadow_queue.hpp"
#include "trace/trace_batch.hpp"

namespace lippmann::bench {
namespace {

constexpr std::size_t kFewSurveyedLights = 4;  // as the final gather has it
constexpr float kFaintGloss = 8.0f;            // likewise
constexpr int kSurveyRouletteDepth = 3;        // as paths have it

struct GroupClass {
  LightGroups group;
  SegmentClass segment;
};
constexpr GroupClass kGroupClasses[] = {{kPointLights, SegmentClass::kToPoint},
                                        {kRoundLights, SegmentClass::kToRound},
                                        {kSun, SegmentClass::kToSun},
                                        {kLamps, SegmentClass::kToLamp},
                                        {kSkyLight, SegmentClass::kToSky}};

/// What is known of the sample of a pixel.
struct SurveyedSample {
  std::uint32_t rays = 0;
  bool touched = false, bent = false;
};

/// Traces samples as the final gather or as paths do, for their segments alone: they bring no light.
class SampleSurveyor : public PathTracer<SampleSurveyor> {
 public:
  SampleSurveyor(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, SampleKind kind,
                 const TouchProbe& probe, std::vector<SurveyedSample>& samples, SampleSurvey& survey)
      : PathTracer(scene, beam, params, {}), kind_(kind), probe_(probe), samples_(samples), survey_(survey) {}

 private:
  friend class PathTracer<SampleSurveyor>;
  static constexpr bool kSeesLight = false, kWidensBeams = false;

  LaneMask begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
    const LaneMask met = probe_.met(packet.ray, active);
    for (int i = 0; i < kLanes; ++i)
      if (active.lane[i]) note(class_of(rays[i]), rays[i].pixel, met.lane[i] != 0);
    return active;
  }
  void end_packet(const RayHitPacket&, const PathRay*) {}
  static Vec2f numbers(const PathRay& ray, int, std::uint32_t pair) { return draw(ray, pair); }

  void scatter(const RayHitPacket& packet, const PathRay* rays) {
    for (int i = 0; i < kLanes; ++i)
      if (vertices_.active.lane[i]) scatter(packet, i, rays[i], vertices_.point(i), vertices_.lengths[i]);
  }

  void scatter(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, float length) {
    Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
    if (kind_ == SampleKind::kGather) {
      ask_hard_lights(point, bsdf, ray);
      if (!(bsdf.diffuse_share() < 1.0f)) return;
      bsdf.remove_diffuse();
      follow(point, bsdf, bsdf.lit_side(point.normal), ray, length);
    } else {
      ask_one_light(point, bsdf, ray);
      follow(point, bsdf, bsdf.lit_side(point.normal), ray, length);
    }
  }

  void trace_shadow_rays() {
    for (std::size_t c = 0; c < kSegmentClasses; ++c) {
      SegmentCount& count = survey_.segments[c];
      shadows_[c].probe(probe_, [&](const ShadowRay& ray) {
        --count.untouched;
        samples_[ray.pixel].touched = true;
      });
      counts_.shadow += shadows_[c].trace(scene_, [](const ShadowRay&, Vec3f) {});
    }
  }

  SegmentClass class_of(const PathRay& ray) const {
    if (ray.depth == 0) return SegmentClass::kCamera;
    return kind_ == SampleKind::kGather || !ray.spread ? SegmentClass::kMirror : SegmentClass::kBounce;
  }

  void note(SegmentClass segment, std::uint32_t pixel, bool touched) {
    SegmentCount& count = survey_.segments[static_cast<std::size_t>(segment)];
    SurveyedSample& sample = samples_[pixel];
    ++count.all, ++sample.rays;
    count.untouched += touched ? 0 : 1;
    sample.touched |= touched;
    sample.bent |= segment == SegmentClass::kMirror;
  }

  void ask(const std::optional<LightSample>& light, SegmentClass segment, const ShadingPoint& point, const Bsdf& bsdf,
           const PathRay& ray) {
    if (!light) return;
    const BsdfValue value = bsdf.evaluate(light->direction);
    if (!is_possible(point, light->direction, value.transmitted)) return;
    if ((value.cosine_f + bsdf.highlight(light->direction)) * light->radiance == Vec3f(0.0f)) return;
    note(segment, ray.pixel, false);  // until trace_shadow_rays() knows better
    shadows_[static_cast<std::size_t>(segment)].push(point, *light, Vec3f(1.0f), ray.pixel, ray.depth + 1);
  }

  void ask_hard_lights(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray) {
    const float pick = draw(ray, kChoicePair).x;
    const Vec2f u = draw(ray, kOnLightPair);
    const LightReceiver at{point.position, bsdf.lit_side(point.normal)};
    const auto ask_one = [&](LightGroups group, SegmentClass segment) {
      if (lights().has(group)) ask(lights().sample(group, at, pick, u), segment, point, bsdf, ray);
    };
    if (lights().points() > kFewSurveyedLights) ask_one(kPointLights, SegmentClass::kToPoint);
    for (std::size_t l = 0; l < lights().points() && lights().points() <= kFewSurveyedLights; ++l)
      ask(lights().point(l, point.position), SegmentClass::kToPoint, point, bsdf, ray);
    if (lights().rounds() > kFewSurveyedLights) ask_one(kRoundLights, SegmentClass::kToRound);
    for (std::size_t k = 0; k < lights().rounds() && lights().rounds() <= kFewSurveyedLights; ++k)
      ask(lights().round(k, point.position, u), SegmentClass::kToRound, point, bsdf, ray);
    ask_one(kSun, SegmentClass::kToSun);
  }

  void ask_one_light(const ShadingPoint& point, const Bsdf& bsdf, const PathRay& ray) {
    const LightReceiver at{point.position, bsdf.lit_side(point.normal)};
    float pick = draw(ray, kChoicePair).x;
    for (const GroupClass& c : kGroupClasses) {
      const float chance = lights().chance(c.group, at);
      if (pick < chance)
        return ask(lights().sample(c.group, at, pick / chance, draw(ray, kOnLightPair)), c.segment, point, bsdf, ray);
      pick -= chance;
    }
  }

  void follow(const ShadingPoint& point, const Bsdf& bsdf, Vec3f lit_side, const PathRay& ray, float length) {
    const Vec2f choice = draw(ray, kChoicePair);
    const std::optional<BsdfSample> sample = bsdf.sample(choice.y, draw(ray, kWayPair));
    if (!sample || !is_possible(point, sample->direction, sample->transmitted)) return;
    Vec3f throughput = ray.throughput * sample->weight;
    if (!goes_on(throughput, ray, choice.x)) return;
    go_on(ray, point, lit_side, *sample, throughput, length, counts_.reflection);
  }

  bool goes_on(Vec3f& throughput, const PathRay& ray, float number) const {
    if (kind_ == SampleKind::kGather) return survives(throughput, std::min(1.0f, kFaintGloss * largest(throughput)), number);
    if (ray.depth + 1 < kSurveyRouletteDepth) return true;
    return survives(throughput, std::min(0.95f, largest(throughput)), draw(ray, kCoveragePair).x);
  }

  SampleKind kind_;
  const TouchProbe& probe_;
  std::vector<SurveyedSample>& samples_;  ///< by pixel
  SampleSurvey& survey_;
  std::array<ShadowQueue, kSegmentClasses> shadows_;
};

void count(const SurveyedSample& sample, SampleSurvey& survey) {
  ++survey.samples.all, survey.rays.all += sample.rays;
  if (sample.touched) return;
  ++survey.samples.untouched, survey.rays.untouched += sample.rays;
  if (sample.bent) return;
  ++survey.seen_alike, survey.rays_seen_alike += sample.rays;
}

}  // namespace

SampleSurvey survey_samples(const Shot& shot, const std::vector<HorizonBox>& boxes, const SurveyParams& params) {
  const ShadedScene& scene = shot.device.shaded();
  const TouchProbe probe(scene, boxes);
  const BeamFootprint beam(shot.optics, shot.world_from_display, params.spp);
  const PacketSource source(shot.optics, shot.world_from_display, RayOrder::kViewTiles, SubPixel{0, params.spp});
  const Vec2i size = film_size(shot.optics);
  SampleSurvey survey;
  std::vector<SurveyedSample> samples(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  SampleSurveyor surveyor(scene, beam, {params.max_depth, hash(0u, params.frame), 0.0f, 1}, params.kind, probe, samples,
                          survey);
  for (int sample = 0; sample < params.spp; ++sample) {
    std::fill(samples.begin(), samples.end(), SurveyedSample{});
    for (int strip = 0; strip < source.strips(); ++strip)
      for_each_batch({}, static_cast<std::size_t>(strip), source.packets_per_strip(),
                     [&](std::span<const int> batch, std::size_t) {
                       trace_batch(scene, StripPackets{source, strip}, {batch, sample, sample + 1}, surveyor);
                     });
    for (const SurveyedSample& of_pixel : samples) count(of_pixel, survey);
  }
  return survey;
}

}  // namespace lippmann::bench
