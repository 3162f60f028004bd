#include "radiance/frame_cache.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace lippmann {
namespace {

/// Cells are as small as the first round of records allows: the more pixels see a place, the smaller.
constexpr float kLargestCell = 8.0f, kSmallestCell = 2.0f;
constexpr double kLeastPerCell = 8.0;

/// How many samples a cell should have: so many times the mean after the first frame's updates, but beyond kEnough of that mean
/// no more than kMostWanted. Cells with fewer get more in every frame. More than the mean, as what moves and what changes is
/// forgotten: with less, frames get worse from the first on.
constexpr float kWanted = 4.0f, kMostWanted = 96.0f, kEnough = 0.8f;

/// Samples of a cell at most that a frame is updated for.
constexpr float kMostPerCell = 256.0f;

/// Textures are filtered as of so many samples a pixel: wider, and they blur what paths show sharply; narrower, and pixels need
/// more samples.
constexpr int kTextureSamples = 16;

constexpr double kLeastCells = 65536.0;

}  // namespace

FrameCache::FrameCache(const Shot& shot, const SurfacePlaces& places, const TraceParams& params, const Workers& workers,
                       CacheHistory& history)
    : shot_(shot),
      pool_(workers.pool),
      context_(workers.context),
      history_(history),
      beam_(shot.optics, shot.world_from_display, kTextureSamples),
      cells_{places, beam_, history.samples_per_cell, history.lights_from},
      updater_(shot, params),
      clamps_(params.clamp_indirect > 0.0f) {}

/// In later frames paths are followed to their ends: what the cache knows may have changed since, and rays tell of what they
/// pass.
UpdateTarget FrameCache::target() const {
  return {cells_,
          *history_.cache,
          pool_,
          context_,
          moved_ ? &*moved_ : nullptr,
          is_first() && !clamps_ && history_.cache->is_resolved()};
}

void FrameCache::start(float samples_per_cell, LightGroup lights_from) {
  if (history_.cache && samples_per_cell == history_.samples_per_cell && lights_from == history_.lights_from) return;
  const Vec2i film = film_size(shot_);
  const double pixels = static_cast<double>(film.x) * static_cast<double>(film.y);
  history_.cache.emplace(static_cast<std::size_t>(std::max(kCellsPerPixel * pixels, kLeastCells)));
  history_.samples_per_cell = cells_.samples_per_cell = samples_per_cell;
  history_.lights_from = cells_.lights_from = lights_from;
  round_ = 0, records_ = 0, rays_since_start_ = 0, update_seconds_ = 0.0;
}

void FrameCache::update(int rounds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (const int end = round_ + rounds; round_ < end && !context_.cancelled; ++round_) {
    const UpdateRound made = updater_.update(target(), round_);
    add(made.rays, counts_);
    records_ += made.records();
    rays_since_start_ += made.rays.total();
  }
  update_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
}

double FrameCache::seconds_per_round() const { return update_seconds_ / std::max(round_, 1); }

double FrameCache::samples_per_cell() const {
  return static_cast<double>(records_) / static_cast<double>(std::max<std::size_t>(history_.cache->cells(), 1));
}

float FrameCache::fitting_cell() {
  start(kLargestCell, CacheSetup{}.lights_from);
  update(1);
  float cell = kLargestCell;
  double per_cell = kRoundsPerFrame * samples_per_cell();
  for (; cell > kSmallestCell && per_cell >= 4.0 * kLeastPerCell; per_cell /= 4.0) cell /= 2.0f;
  return cell;
}

void FrameCache::set_up(const CacheSetup& setup, float fitting_cell) {
  start(setup.cell * fitting_cell, setup.lights_from);
  update(setup.rounds - round_);
  history_.cache->resolve(pool_);
  history_.rounds = round_;
  const auto mean = static_cast<float>(samples_per_cell());
  history_.mean = mean;
  history_.enough = std::max(kEnough * mean, std::min(kWanted * mean, kMostWanted));
}

void FrameCache::go_on(const std::vector<HorizonBox>& moving) {
  RadianceCache& cache = *history_.cache;
  cache.begin_frame([this](std::uint32_t thing, Vec3f at) { return cells_.places.moved(thing, at); }, pool_);
  moved_.emplace(shot_.device.shaded(), moving);
  const UpdateRound everywhere = updater_.update(target(), 0);
  add(everywhere.rays, counts_);
  // The more is forgotten, the more has to be found anew, as in the first frame.
  const float lost = cache.forget(pool_);
  enough_ = std::max(history_.enough, lost * history_.mean);
  PacketGroups sparse;
  add_sparse_groups(everywhere, cache, enough_, sparse);
  update_sparse(std::move(sparse), 1, history_.rounds);
  cache.resolve(pool_);
  round_ = history_.rounds;
}

/// Rounds of groups that have met sparse cells, until there are none any more.
void FrameCache::update_sparse(PacketGroups sparse, int first_round, int end) {
  RadianceCache& cache = *history_.cache;
  PacketGroups still;
  for (int round = first_round; round < end && !context_.cancelled; ++round) {
    const UpdateRound made = updater_.update_sparse(target(), round, enough_, sparse);
    add(made.rays, counts_);
    add_sparse_groups(made, cache, enough_, still);
    if (round % kRoundsPerFrame == 0) {  // all packets of a group have had their turn
      cache.forget(pool_);
      sparse = std::exchange(still, {});
    }
  }
  cache.forget(pool_);
}

void FrameCache::update_more(int attempt) {
  history_.enough = std::min(2.0f * history_.enough, std::max(kMostPerCell, history_.mean));
  enough_ = std::max(enough_, history_.enough);
  const int first = round_;
  round_ += 2 * kRoundsPerFrame << attempt;
  const UpdateRound made = updater_.update(target(), first);
  add(made.rays, counts_);
  PacketGroups sparse;
  add_sparse_groups(made, *history_.cache, enough_, sparse);
  update_sparse(std::move(sparse), first + 1, round_);
  history_.cache->resolve(pool_);
}

}  // namespace lippmann
