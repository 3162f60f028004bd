#include "radiance/cache_update.hpp"

#include "trace/strip_order.hpp"

namespace lippmann {
namespace {

/// Queries at once: one for each ray at most.
constexpr int kMostQueries = kPacketsPerBlock * kLanes;

}  // namespace

float CacheCells::size(float path_length) const {
  const Vec2f widths = beam.widths(path_length);
  return samples_per_cell * std::max(std::min(widths.x, widths.y), 1e-20f);
}

CacheUpdate::CacheUpdate(const ShadedScene& scene, const CacheCells& cells, const PathParams& params,
                         std::optional<SparseCells> sparse, const TouchProbe* moved, CacheRecords& made)
    : PathTracer(scene, cells.beam, params, {}),
      cells_(cells),
      sparse_(sparse),
      watches_(moved != nullptr),
      made_(made),
      light_(kMostQueries, 1, 3),
      changes_(kMostQueries),
      paths_(scene, cells.beam, params, {.all = light_.data.data()}) {
  if (moved) paths_.watch(*moved, changes_);
}

void CacheUpdate::finish() {
  PathTracer::finish();
  paths_.finish();
  for (std::size_t q = 0; q < queries_.size(); ++q) {
    float* light = &light_.data[3 * q];
    RadianceRecord& record = made_.records.emplace_back();
    record.place = queries_[q].place, record.also = queries_[q].also;
    record.light = {light[0], light[1], light[2]};
    // What moves by itself passes its own box with every ray: how far it has moved (RadianceCache::Motion) and turned tells
    // what may have changed.
    if (watches_) {
      const PathIntegrator::PossibleChange& change = changes_[q];
      record.changed_light = queries_[q].moves ? change.turned_light : change.light;
      record.changed_share = std::min(1.0f, queries_[q].moves ? change.turned_share : change.share);
    }
    made_.sources.push_back(queries_[q].source);
    light[0] = light[1] = light[2] = 0.0f;
    changes_[q] = {};
  }
  queries_.clear();
}

RayCounts CacheUpdate::counts() const {
  RayCounts all = counts_;
  lippmann::add(paths_.counts(), all);
  return all;
}

void CacheUpdate::scatter(const RayHitPacket& packet, const PathRay* rays) {
  for (int i = 0; i < kLanes; ++i)
    if (vertices_.active.lane[i]) scatter(packet, i, rays[i]);
}

void CacheUpdate::scatter(const RayHitPacket& packet, int i, const PathRay& ray) {
  const ShadingPoint& point = vertices_.point(i);
  const float length = vertices_.lengths[i];
  Bsdf bsdf = bsdf_at(scene_, packet, surface_, i);
  const float share = bsdf.diffuse_share();
  const Vec2f choice = draw(ray, kChoicePair);
  if (choice.y < share) return ask(packet, i, ray, point, bsdf, length, choice.x);
  bsdf.remove_diffuse();
  const std::optional<BsdfSample> sample = bsdf.sample((choice.y - share) / (1.0f - share), draw(ray, kWayPair));
  if (sample && is_possible(point, sample->direction, sample->transmitted))
    go_on(ray, point, bsdf.lit_side(point.normal), *sample, Vec3f(1.0f), length, counts_.reflection);
}

void CacheUpdate::ask(const RayHitPacket& packet, int i, const PathRay& ray, const ShadingPoint& point, const Bsdf& bsdf,
                      float length, float pick) {
  PathRay query = ray;
  query.pixel = static_cast<std::uint32_t>(queries_.size());
  query.throughput = Vec3f(1.0f);
  Vec3f normal = bsdf.normal();
  const CachePoint place = cells_.places(packet, surface_, i, normal, cells_.size(length));
  if (sparse_ && !sparse_->at(place)) return;
  const bool moves = cells_.places.moves(surface_.instance[i]);
  queries_.push_back({place, cells_.places.sides_near(packet, surface_, i, normal), ray.pixel, moves});
  const Affine3f before = watches_ && moves ? cells_.places.before_from_now(surface_.instance[i]) : Affine3f{};
  paths_.gather_diffuse(point, bsdf, query, length, cells_.lights_from, {pick, draw(ray, kOnLightPair), draw(ray, kWayPair)},
                        watches_ && moves ? &before : nullptr);
}

}  // namespace lippmann
