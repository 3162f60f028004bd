#include "trace/light_feeder.hpp"

#include "core/random.hpp"
#include "trace/scene_query.hpp"
#include "trace/strip_order.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

/// Queries of a group: one for each ray at most.
constexpr int kMostQueries = kPacketsPerBlock * kLanes;

}  // namespace

float LightCells::size(float path_length) const {
  const Vec2f widths = beam.widths(path_length);
  return samples_per_cell * std::max(std::min(widths.x, widths.y), 1e-20f);
}

LightFeeder::LightFeeder(const DeviceScene::Impl& scene, const LightCells& cells, const PathParams& params)
    : scene_(scene),
      cells_(cells),
      params_(params),
      light_(kMostQueries, 1, 3),
      doubts_(kMostQueries),
      paths_(scene, cells.beam, params, {light_.data.data()}) {}

void LightFeeder::begin_group(std::uint32_t group) {
  group_ = group;
  started_ = 0;
}

void LightFeeder::primary(RayHitPacket& packet, const LaneMask& active, std::uint32_t source) {
  clear_hits(packet);
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  PathRay rays[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    counts_.primary += active.lane[i] != 0;
    if (!active.lane[i]) continue;
    rays[i] = primary_path_ray(packet, i, source);
    rays[i].seed = hash(params_.seed, group_), rays[i].index = started_++;
  }
  shade(packet, active, rays);
}

void LightFeeder::finish_group(FedLight& fed) {
  while (!next_.empty()) {
    std::swap(wave_, next_);
    next_.clear();
    trace_wave(scene_, wave_, [this](const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
      shade(packet, active, rays);
    });
  }
  paths_.finish_batch();
  for (std::size_t q = 0; q < asked_.size(); ++q) {
    float* light = &light_.data[3 * q];
    LightRecord& record = fed.records.emplace_back();
    record.place = asked_[q].place;
    record.light = {light[0], light[1], light[2]};
    // What moves by itself passes its own box with every ray: how far it has moved (LightCache::Motion) and turned tells what
    // is doubtful.
    if (watches_) {
      const PathTracer::Doubt& doubt = doubts_[q];
      record.doubtful_light = asked_[q].moves ? doubt.turned_light : doubt.light;
      record.doubtful_share = std::min(1.0f, asked_[q].moves ? doubt.turned_share : doubt.share);
    }
    fed.sources.push_back(asked_[q].source);
    light[0] = light[1] = light[2] = 0.0f;
    doubts_[q] = {};
  }
  asked_.clear();
}

RayCounts LightFeeder::counts() const {
  RayCounts all = counts_;
  add(paths_.counts(), all);
  return all;
}

void LightFeeder::shade(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays) {
  Lanes path_length;
  for (int i = 0; i < kLanes; ++i) path_length[i] = active.lane[i] ? rays[i].path_length : 0.0f;
  evaluate_surfaces(scene_, packet, active, path_length, cells_.beam, surface_);
  for (int i = 0; i < kLanes; ++i)
    if (active.lane[i] && surface_.hit.lane[i]) shade_lane(packet, i, rays[i]);
}

void LightFeeder::shade_lane(const RayHitPacket& packet, int i, const PathRay& ray) {
  const ShadingPoint point = shading_point(scene_, surface_, i);
  // Drawn where they are asked for: most places are not scarce.
  const auto numbers = [&](std::uint32_t pair) {
    PathSampler sampler(ray.seed, ray.index);
    sampler.jump_to(kPairsPerEvent * ray.events + pair);
    return sampler.next();
  };
  const float length = ray.path_length + packet.ray.tfar[i];
  if (point.coverage < 1.0f && numbers(3).y >= point.coverage) {
    if (ray.events < kMostEvents) next_.push_back(passed(ray, point, length));
    return;
  }
  if (!point.scatters || ray.depth + 1 > params_.max_depth) return;
  const Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  const float share = bsdf.diffuse_share();
  const Vec2f choice = numbers(0);
  if (choice.y < share) {
    PathRay query = ray;
    query.pixel = static_cast<std::uint32_t>(asked_.size());
    query.throughput = Vec3f(1.0f);
    Vec3f normal = bsdf.normal();
    const LightPlace place = cells_.places(packet, surface_, i, normal, cells_.size(length));
    if (scarce_ && !scarce_->at(place)) return;
    const bool moves = cells_.places.moves(surface_.instance[i]);
    asked_.push_back({place, ray.pixel, moves});
    const Affine3f before = watches_ && moves ? cells_.places.before_from_now(surface_.instance[i]) : Affine3f{};
    paths_.gather_diffuse(point, bsdf, query, length, cells_.lights_from, {choice.x, numbers(1), numbers(2)},
                          watches_ && moves ? &before : nullptr);
    return;
  }
  const std::optional<BsdfSample> sample = bsdf.without_diffuse().sample((choice.y - share) / (1.0f - share), numbers(2));
  if (!sample || (glm::dot(point.facet, sample->direction) < 0.0f) != sample->transmitted) return;
  ++counts_.reflection;
  next_.push_back(scattered(ray, point, *sample, Vec3f(1.0f), length));
}

}  // namespace lippmann
