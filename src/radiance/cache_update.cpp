#include "radiance/cache_update.hpp"

#include "trace/strip_order.hpp"

namespace lippmann {
namespace {

/// Queries at once: one for each ray at most.
constexpr int kMostQueries = kPacketsPerBlock * kLanes;

/// So many directions into the sky are drawn one by one: where cells are to be sparse, few lanes ask.
constexpr int kFewLanes = 4;

int count(const LaneMask& lanes) {
  int sum = 0;
  for (const int lane : lanes.lane) sum -= lane;
  return sum;
}

}  // namespace

CacheUpdate::CacheUpdate(const ShadedScene& scene, const CacheCells& cells, const UpdatePaths& paths,
                         std::optional<SparseCells> sparse, CacheRecords& made)
    : PathTracer(scene, cells.beam, paths.params, {}),
      cells_(cells),
      sparse_(sparse),
      watches_(paths.moved != nullptr),
      made_(made),
      light_(kMostQueries, 1, 3),
      deepest_(kMostQueries, 1, 3),
      changes_(kMostQueries),
      paths_(scene, cells.beam, paths.params, {.all = light_.data.data(), .deepest = deepest_.data.data()}) {
  if (paths.moved) paths_.watch(*paths.moved, changes_);
  if (paths.ends)
    ends_.emplace(scene, cells, *paths.ends, paths.params, PathFilm{.all = light_.data.data()},
                  FinalGatherOptions{.light = LookedUp::kWithoutDeepest});
}

void CacheUpdate::finish() {
  PathTracer::finish();
  paths_.finish();
  if (ends_) ends_->finish();
  for (std::size_t q = 0; q < queries_.size(); ++q) {
    float *light = &light_.data[3 * q], *deepest = &deepest_.data[3 * q];
    RadianceRecord& record = made_.records.emplace_back();
    record.place = queries_[q].place, record.also = queries_[q].also;
    record.light = {light[0], light[1], light[2]};
    if (!ends_) record.deepest = luminance(Vec3f(deepest[0], deepest[1], deepest[2]));
    // What moves by itself passes its own box with every ray: how far it has moved (RadianceCache::Motion) and turned tells
    // what may have changed.
    if (watches_) {
      const PathIntegrator::PossibleChange& change = changes_[q];
      record.changed_light = queries_[q].moves ? change.turned_light : change.light;
      record.changed_share = std::min(1.0f, queries_[q].moves ? change.turned_share : change.share);
    }
    made_.sources.push_back(queries_[q].source);
    light[0] = light[1] = light[2] = deepest[0] = deepest[1] = deepest[2] = 0.0f;
    changes_[q] = {};
  }
  queries_.clear();
}

RayCounts CacheUpdate::counts() const {
  RayCounts all = counts_;
  lippmann::add(paths_.counts(), all);
  if (ends_) lippmann::add(ends_->counts(), all);
  return all;
}

LaneMask CacheUpdate::begin_packet(const RayHitPacket&, const LaneMask& active, const PathRay* rays) {
  if (surface_.any_hit) draw_numbers(rays, surface_.any_see_through);
  return active;
}

/// As often as the diffuse part is drawn, a record is made of it; else the path goes on to where one may be.
void CacheUpdate::scatter(const RayHitPacket& packet, const PathRay* rays) {
  make_bsdfs(packet);
  LaneMask asking{}, passing{};
  Lanes lobe{};
  for (int i = 0; i < kLanes; ++i) {
    if (!vertices_.active.lane[i]) continue;
    const float share = vertices_.bsdfs.diffuse_share(i), choice = numbers(rays[i], i, kChoicePair).y;
    if (choice < share)
      asking.lane[i] = ask(packet, i, rays[i]) ? -1 : 0;
    else
      passing.lane[i] = -1, lobe[i] = (choice - share) / (1.0f - share);
  }
  if (any(asking)) gather(asking, rays);
  if (any(passing)) pass_on(passing, lobe, rays);
}

void CacheUpdate::pass_on(const LaneMask& lanes, const Lanes& lobe, const PathRay* rays) {
  vertices_.bsdfs.remove_diffuse();
  BsdfSamples samples;
  vertices_.bsdfs.sample(lanes, lobe, numbers(kWayPair).x, numbers(kWayPair).y, samples);
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    const ShadingPoint& point = vertices_.point(i);
    const std::optional<BsdfSample> sample = samples.get(i);
    if (sample && is_possible(point, sample->direction, sample->transmitted))
      go_on(rays[i], point, vertices_.bsdfs.lit_side(i, point.normal), *sample, Vec3f(1.0f), vertices_.lengths[i],
            counts_.reflection);
  }
}

/// Whether the cell wants a record.
bool CacheUpdate::ask(const RayHitPacket& packet, int i, const PathRay& ray) {
  Vec3f normal = vertices_.bsdfs.normal(i);
  const CachePoint place = cells_.places(packet, surface_, i, normal, cells_.size(vertices_.lengths[i]));
  if (sparse_ && !sparse_->at(place)) return false;
  query_of_lane_[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(queries_.size());
  queries_.push_back(
      {place, cells_.places.sides_near(packet, surface_, i, normal), ray.pixel, cells_.places.moves(surface_.instance[i])});
  return true;
}

void CacheUpdate::gather(const LaneMask& lanes, const PathRay* rays) {
  const LightGroups groups{cells_.lights_from, LightGroup::kEnd};
  const bool of_sky_alone = cells_.lights_from == LightGroup::kSky && lights().has(kSkyLight);
  const bool drawn_together = of_sky_alone && count(lanes) > kFewLanes;
  const auto light_for = [&](int i) -> std::optional<LightSample> {
    if (drawn_together) return LightTable::sky_sample(sky_draws(), i, 1.0f);
    const Vec2f on_light(numbers(kOnLightPair).x[i], numbers(kOnLightPair).y[i]);
    if (of_sky_alone) return lights().sky_sample(on_light);
    return lights().sample(groups, {vertices_.point(i).position, vertices_.bsdfs.normal(i)}, numbers(kChoicePair).x[i],
                           on_light);
  };
  for (int i = 0; i < kLanes; ++i) {
    if (!lanes.lane[i]) continue;
    PathRay query = rays[i];
    query.pixel = query_of_lane_[static_cast<std::size_t>(i)];
    query.throughput = Vec3f(1.0f);
    const bool moves = watches_ && queries_[query.pixel].moves;
    const Affine3f before = moves ? cells_.places.before_from_now(surface_.instance[i]) : Affine3f{};
    gather({vertices_.point(i), vertices_.bsdfs, i, vertices_.lengths[i], moves ? &before : nullptr}, query, light_for(i),
           numbers(rays[i], i, kWayPair));
  }
}

void CacheUpdate::gather(const PathIntegrator::DiffuseVertex& at, const PathRay& ray, const std::optional<LightSample>& light,
                         Vec2f way) {
  if (!ends_) return paths_.gather_diffuse(at, ray, cells_.lights_from, light, way);
  if (light) paths_.aim_at(at, ray, *light);
  if (const std::optional<PathRay> path = paths_.bounce(at, ray, cells_.lights_from, way)) ends_->take(*path);
}

}  // namespace lippmann
