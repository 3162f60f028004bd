// The cache of soft light on its own: what it was fed against what it answers.
#include "radiance/radiance_cache.hpp"

#include <gtest/gtest.h>

#include <random>

#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kMostWanted = 1u << 20;

/// x and y in cells of the smallest size from a corner that cells of all sizes share (cell_keys.hpp).
CachePoint place(float x, float y = 0.3f, std::uint32_t thing = 7) {
  constexpr float kCorner = 8.0f / 3.0f;
  return {Vec3f(x, y, 0.1f) + kCorner, thing, 1, 1.0f};
}

/// `count` places spread over x in [0, 32), y in [0, 8), and light(x) on them, noise of deviation `noise` added.
template <class Light>
std::vector<RadianceRecord> spread(int count, float noise, unsigned seed, const Light& light) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform;
  std::normal_distribution<float> normal;
  std::vector<RadianceRecord> records;
  for (int i = 0; i < count; ++i) {
    const float x = 32.0f * uniform(random), y = 8.0f * uniform(random);
    records.push_back({place(x, y), Vec3f(light(x) + noise * normal(random))});
  }
  return records;
}

float still(std::uint32_t, Vec3f) { return 0.0f; }

Vec4f pick(const RadianceCache& cache, const CachePoint& place, Vec2f u, EdgesToPaths edges = EdgesToPaths::kFaint) {
  CacheQueries queries;
  queries.set(3, place, {0, 0, 1}, u);
  Lanes3 light;
  const LaneMask known = cache.pick(queries, edges, LookedUp::kAll, light);
  for (int i = 0; i < kLanes; ++i) EXPECT_TRUE(i == 3 || known.lane[i] == 0) << "a lane that did not ask";
  return known.lane[3] ? Vec4f(light.get(3), 1.0f) : Vec4f(0.0f);
}

void update(RadianceCache& cache, const std::vector<RadianceRecord>& records, const ThreadPool& pool = ThreadPool(1)) {
  const std::vector<std::span<const RadianceRecord>> pieces{records};
  cache.add(pieces, pool);
  cache.resolve(pool);
}

TEST(RadianceCache, surfaces_learn_from_those_that_go_smoothly_over_into_them) {
  RadianceCache cache(kMostWanted);
  std::vector<RadianceRecord> records = spread(4000, 0.0f, 1, [](float) { return 1.0f; });
  for (RadianceRecord& record : records) record.also = {8, 0};
  update(cache, records);
  EXPECT_FLOAT_EQ(pick(cache, place(3, 0.3f, 8), Vec2f(0.5f)).x, 1.0f);
  EXPECT_EQ(cache.samples(place(3, 0.3f, 8)), cache.samples(place(3)));
  EXPECT_EQ(pick(cache, place(3, 0.3f, 9), Vec2f(0.5f)).w, 0.0f);
}

TEST(RadianceCache, a_place_that_was_never_fed_is_unknown) {
  RadianceCache cache(kMostWanted);
  EXPECT_EQ(cache.look_up(place(3)).w, 0.0f);
  EXPECT_EQ(pick(cache, place(3), Vec2f(0.5f)).w, 0.0f);
}

// Hits on a floor at 0 lie at 0 only as far as Embree's rounding goes, which differs from processor to processor.
TEST(RadianceCache, rounding_does_not_split_a_plane_at_a_round_number_into_two_layers_of_cells) {
  for (const float height : {0.0f, 1.0f, -2.0f, 3.0f, 0.5f}) {
    RadianceCache flat(kMostWanted), rounded(kMostWanted);
    std::vector<RadianceRecord> records = spread(4000, 0.0f, 1, [](float) { return 1.0f; });
    for (RadianceRecord& record : records) record.place.position.z = height;
    update(flat, records);
    for (std::size_t i = 0; i < records.size(); ++i) records[i].place.position.z = height + (i % 2 ? 1e-6f : -1e-6f);
    update(rounded, records);
    EXPECT_EQ(rounded.cells(), flat.cells()) << height;
  }
}

TEST(RadianceCache, a_place_that_was_fed_once_has_that_light_all_around) {
  RadianceCache cache(kMostWanted);
  update(cache, {{place(3), {1.0f, 2.0f, 3.0f}}});
  for (const float x : {3.0f, 3.9f, 4.4f}) {  // its own cell, and what larger ones know
    const Vec4f light = cache.look_up(place(x));
    EXPECT_GT(light.w, 0.0f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], static_cast<float>(c + 1), 1e-5f) << x;
  }
}

TEST(RadianceCache, other_things_and_other_sides_share_nothing) {
  RadianceCache cache(kMostWanted);
  update(cache, {{place(3, 0.3f, 7), Vec3f(1.0f)}});
  EXPECT_EQ(cache.look_up(place(3, 0.3f, 8)).w, 0.0f);
}

// 4,096 records on 256 cells: 16 each, whose mean alone scatters by 0.25.
TEST(RadianceCache, noise_on_even_light_is_averaged_over_more_than_a_cell) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(4096, 1.0f, 1, [](float) { return 5.0f; }));
  double squares = 0.0;
  int count = 0;
  for (float x = 2.0f; x < 30.0f; x += 0.37f, ++count) {
    const double d = static_cast<double>(cache.look_up(place(x, 4.0f)).x) - 5.0;
    squares += d * d;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.1);  // means over 64 cells, as in the largest, would scatter by 0.03
}

TEST(RadianceCache, an_edge_of_light_stays_where_it_is) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(16384, 0.1f, 2, [](float x) { return x < 16.0f ? 0.0f : 1.0f; }));
  // One cell away, though the largest cells are eight wide.
  EXPECT_NEAR(cache.look_up(place(14.4f, 4.0f)).x, 0.0f, 0.06f);
  EXPECT_NEAR(cache.look_up(place(17.6f, 4.0f)).x, 1.0f, 0.06f);
}

/// How many places are left to paths, by x, among those one apart all over the strip that spread() covers.
std::vector<int> left_to_paths(const RadianceCache& cache, EdgesToPaths edges = EdgesToPaths::kFaint) {
  std::vector<int> count(32);
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 8; ++y)
      count[static_cast<std::size_t>(x)] +=
          pick(cache, place(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), Vec2f(0.5f), edges).w == 0.0f;
  return count;
}

// The edge lies between the cells 15 and 16: these two bend, and no other.
TEST(RadianceCache, places_at_an_edge_of_light_are_left_to_paths) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(16384, 0.1f, 5, [](float x) { return x < 16.0f ? 0.1f : 0.8f; }));
  const std::vector<int> left = left_to_paths(cache);
  for (int x = 0; x < 32; ++x) EXPECT_EQ(left[static_cast<std::size_t>(x)], x == 15 || x == 16 ? 8 : 0) << x;
}

// Beside an edge from 0.1 to 0.8, the cells around have a mean of 0.275 and bend by 0.7: codes of 0.7 times 0.275 and 0.625
// differ by 0.22. From 0.1 to 0.35, likewise, by 0.11, and to 0.2 by 0.06.
TEST(RadianceCache, only_so_strong_edges_are_left_to_paths_as_is_asked_for) {
  const auto left = [](float bright, EdgesToPaths edges) {
    RadianceCache cache(kMostWanted);
    update(cache, spread(16384, 0.0f, 5, [&](float x) { return x < 16.0f ? 0.1f : bright; }));
    return left_to_paths(cache, edges)[15];
  };
  EXPECT_EQ(left(0.8f, EdgesToPaths::kNone), 0);
  EXPECT_EQ(left(0.8f, EdgesToPaths::kStrong), 8);
  EXPECT_EQ(left(0.8f, EdgesToPaths::kFaint), 8);
  EXPECT_EQ(left(0.35f, EdgesToPaths::kStrong), 0);
  EXPECT_EQ(left(0.35f, EdgesToPaths::kVisible), 8);
  EXPECT_EQ(left(0.2f, EdgesToPaths::kVisible), 0);
  EXPECT_EQ(left(0.2f, EdgesToPaths::kFaint), 8);
}

// Eight samples of a cell scatter by as much as half of the edge: cells around both are certain of it.
TEST(RadianceCache, larger_cells_tell_where_noisy_light_has_an_edge) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(2048, 0.35f, 5, [](float x) { return x < 16.0f ? 0.1f : 0.8f; }));
  const std::vector<int> left = left_to_paths(cache);
  EXPECT_GE(left[15] + left[16], 8);
}

TEST(RadianceCache, no_place_is_left_to_paths_where_light_changes_evenly) {
  for (const float slope : {0.0f, 0.02f}) {
    RadianceCache cache(kMostWanted);
    update(cache, spread(16384, 0.1f, 5, [&](float x) { return 0.1f + slope * x; }));
    for (const int left : left_to_paths(cache)) EXPECT_EQ(left, 0) << slope;
  }
}

TEST(RadianceCache, edges_that_nobody_sees_are_left_to_cells) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(16384, 0.0f, 5, [](float x) { return x < 16.0f ? 0.50f : 0.55f; }));
  for (const int left : left_to_paths(cache)) EXPECT_EQ(left, 0);
  RadianceCache dark(kMostWanted);
  update(dark, spread(16384, 0.0f, 5, [](float x) { return x < 16.0f ? 0.0f : 0.002f; }));
  for (const int left : left_to_paths(dark)) EXPECT_EQ(left, 0);
}

// Samples of which one in ten is ten times as bright: chance makes edges everywhere, of which few may be believed.
TEST(RadianceCache, noise_makes_no_edges) {
  RadianceCache cache(kMostWanted);
  std::mt19937 random(9);
  update(cache, spread(4096, 0.0f, 5, [&](float) { return random() % 10 == 0 ? 2.0f : 0.2f; }));
  int all = 0;
  for (const int left : left_to_paths(cache)) all += left;
  EXPECT_LE(all, 5);  // there are 256 places
}

TEST(RadianceCache, picking_gives_the_interpolated_light_on_average) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(16384, 0.0f, 3, [](float x) { return x; }));
  const CachePoint at = place(11.7f, 4.2f);
  double sum = 0.0;
  constexpr int kSide = 32;
  for (int i = 0; i < kSide * kSide; ++i)
    sum += static_cast<double>(
        pick(cache, at, {(static_cast<float>(i % kSide) + 0.5f) / kSide, (static_cast<float>(i / kSide) + 0.5f) / kSide}).x);
  EXPECT_NEAR(sum / (kSide * kSide), static_cast<double>(cache.look_up(at).x), 0.02);
}

TEST(RadianceCache, lanes_are_picked_as_each_alone) {
  RadianceCache cache(kMostWanted);
  update(cache, spread(600, 0.5f, 5, [](float x) { return x; }));  // many smallest cells stay unknown
  CacheQueries queries;
  for (int i = 0; i < kLanes; ++i)
    if (i % 5 != 4) queries.set(i, place(1.7f * static_cast<float>(i), 3.1f), {0, 0, 1}, {0.05f * static_cast<float>(i), 0.3f});
  Lanes3 together;
  const LaneMask known = cache.pick(queries, EdgesToPaths::kFaint, LookedUp::kAll, together);
  for (int i = 0; i < kLanes; ++i) {
    if (i % 5 == 4) continue;
    const Vec4f alone = pick(cache, queries.place(i), {queries.u[i], queries.v[i]});
    EXPECT_EQ(known.lane[i] != 0, alone.w > 0.0f) << i;
    EXPECT_TRUE(!known.lane[i] || together.get(i) == Vec3f(alone)) << i;
  }
}

TEST(RadianceCache, frames_that_agree_add_up) {
  const auto error_after = [](int frames) {
    RadianceCache cache(kMostWanted);
    const ThreadPool pool(1);
    for (int f = 0; f < frames; ++f) {
      cache.begin_frame(still, pool);
      update(cache, spread(512, 1.0f, static_cast<unsigned>(f + 10), [](float) { return 5.0f; }));
    }
    double squares = 0.0;
    for (float x = 1.0f; x < 31.0f; x += 0.25f)
      squares += std::pow(static_cast<double>(cache.look_up(place(x, 4.0f)).x) - 5.0, 2);
    return std::sqrt(squares / 120.0);
  };
  EXPECT_LT(error_after(16), 0.6 * error_after(1));  // a quarter, but for what larger cells know from the start
}

/// A frame of the cache: what was fed becomes the past, and is forgotten as far as `records` ask for.
float next_frame(RadianceCache& cache, const std::vector<RadianceRecord>& records, int forgets = 1) {
  const ThreadPool pool(1);
  cache.begin_frame(still, pool);
  const std::vector<std::span<const RadianceRecord>> pieces{records};
  cache.add(pieces, pool);
  float lost = 0.0f;
  for (int i = 0; i < forgets; ++i) lost = cache.forget(pool);
  cache.resolve(pool);
  return lost;
}

float one(float) { return 1.0f; }

TEST(RadianceCache, light_that_goes_out_is_forgotten_in_the_same_frame) {
  RadianceCache cache(kMostWanted);
  for (unsigned f = 0; f < 20; ++f) next_frame(cache, spread(2048, 0.2f, f, one));
  EXPECT_GT(next_frame(cache, spread(2048, 0.0f, 40, [](float) { return 0.0f; })), 0.95f);
  for (float x = 0.5f; x < 32.0f; x += 1.0f) EXPECT_LT(cache.look_up(place(x, 4.0f)).x, 0.05f) << x;
}

// One of 200 samples is 200 times as bright. Of 16 new frames none says anything else than what is known.
TEST(RadianceCache, noise_is_no_reason_to_forget) {
  const auto noisy = [](unsigned seed) {
    std::mt19937 random(seed);
    std::vector<RadianceRecord> records = spread(4096, 0.0f, seed, one);
    for (RadianceRecord& r : records) r.light = Vec3f(random() % 200 == 0 ? 200.0f : 1.0f);
    return records;
  };
  RadianceCache cache(kMostWanted);
  update(cache, noisy(1));
  float lost = 0.0f;
  for (unsigned f = 2; f < 18; ++f) lost += next_frame(cache, noisy(f)) / 16.0f;
  EXPECT_LT(lost, 0.05f);
}

// Weighed by their own scatter, cells with a bright sample are drawn to those without: 22 % of all light is lost. 1 % is
// allowed; how much is lost or gained depends on kPriorScatter, which was chosen so that it is less here.
TEST(RadianceCache, rare_bright_samples_lose_no_light) {
  double fed = 0.0, known = 0.0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    std::vector<RadianceRecord> records = spread(16384, 0.0f, 100 + seed, one);
    for (RadianceRecord& r : records) {
      r.light = Vec3f(random() % 200 == 0 ? 200.0f : 1.0f);
      fed += static_cast<double>(r.light.x) / (8.0 * 16384.0);
    }
    RadianceCache cache(kMostWanted);
    update(cache, records);
    for (const RadianceRecord& r : records) known += static_cast<double>(pick(cache, r.place, Vec2f(0.5f)).x) / (8.0 * 16384.0);
  }
  EXPECT_NEAR(known, fed, 0.01 * fed);
}

// Four samples a cell, of which one in four is 4 and the others are next to nothing: in three cells of ten all are dark, and
// nothing but those around says that this was bad luck.
TEST(RadianceCache, cells_whose_few_samples_were_all_dark_are_not_sure_of_it) {
  double squares = 0.0;
  int dark = 0, count = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 random(seed);
    std::vector<RadianceRecord> records = spread(1024, 0.0f, 200 + seed, one);
    for (RadianceRecord& r : records) r.light = Vec3f(random() % 4 == 0 ? 4.0f : 0.01f);
    RadianceCache cache(kMostWanted);
    update(cache, records);
    for (float x = 2.0f; x < 30.0f; x += 0.37f)
      for (float y = 1.0f; y < 7.0f; y += 0.37f, ++count) {
        const double light = static_cast<double>(cache.look_up(place(x, y)).x);
        squares += (light - 1.0) * (light - 1.0);
        dark += light < 0.5 ? 1 : 0;
      }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.26);         // 0.22; with no more than a prior of 8 samples 0.32,
  EXPECT_LT(static_cast<double>(dark) / count, 0.06);  // and 12 % of all places too dark by half in place of 3.5 %
}

// 64 samples a cell; noise of deviation 0.2. If all of the light may have changed, its variance grows by 1 (or, of other rays
// than those to lamps, by 1 / 4): the past then counts for 0.2^2 / 1 or 0.2^2 / 0.25 of a sample.
TEST(RadianceCache, what_moves_takes_weight_from_the_past) {
  const auto left = [](float light, float share, int forgets) {
    RadianceCache cache(kMostWanted);
    update(cache, spread(16384, 0.2f, 1, one));
    std::vector<RadianceRecord> records = spread(16384, 0.2f, 2, one);
    for (RadianceRecord& r : records) r.changed_light = light, r.changed_share = share;
    return 1.0f - next_frame(cache, records, forgets);
  };
  EXPECT_GT(left(0.0f, 0.0f, 1), 0.98f);
  EXPECT_LT(left(1.0f, 0.0f, 1), 0.002f);
  EXPECT_LT(left(0.0f, 1.0f, 1), 0.006f);
  EXPECT_GT(left(0.0f, 0.02f, 1), 0.5f);  // 64 x 0.01^2 beside 0.2^2
  EXPECT_EQ(left(0.0f, 0.1f, 1), left(0.0f, 0.1f, 3));
}

// Light that grows by 1 a unit, without noise but for the cells' own width: moved by a cell's width, the past is worth little.
TEST(RadianceCache, things_that_move_forget_what_differs_around_them) {
  const ThreadPool pool(1);
  const auto past_of = [&](float moved, const auto& light) {
    RadianceCache cache(kMostWanted);
    update(cache, spread(8192, 0.0f, 3, light));
    const float before = cache.samples(place(16.5f, 4.5f));
    cache.begin_frame([&](std::uint32_t thing, Vec3f) { return thing == 7 ? moved : 0.0f; }, pool);
    return cache.samples(place(16.5f, 4.5f)) / before;
  };
  const auto ramp = [](float x) { return 1.0f + x; };
  EXPECT_FLOAT_EQ(past_of(0.0f, ramp), 1.0f);
  EXPECT_LT(past_of(1.0f, ramp), 0.2f);
  EXPECT_GT(past_of(0.1f, ramp), 2.0f * past_of(1.0f, ramp));
  EXPECT_GT(past_of(1.0f, [](float) { return 1.0f; }), 0.99f);  // even light: it stays the same wherever things go
}

TEST(RadianceCache, samples_are_those_of_the_smallest_cell) {
  RadianceCache cache(kMostWanted);
  EXPECT_EQ(cache.samples(place(3.5f)), 0.0f);
  update(cache, {{place(3.2f), Vec3f(1.0f)}, {place(3.7f), Vec3f(1.0f)}, {place(4.5f), Vec3f(1.0f)}});
  EXPECT_EQ(cache.samples(place(3.5f)), 2.0f);
}

TEST(RadianceCache, share_of_past_tells_old_light_from_new) {
  RadianceCache cache(kMostWanted);
  const ThreadPool pool(1);
  update(cache, {{place(3), Vec3f(1.0f)}});
  EXPECT_EQ(cache.share_of_past(place(3)), 0.0f);
  cache.begin_frame(still, pool);
  EXPECT_EQ(cache.share_of_past(place(3)), 1.0f);
  update(cache, {{place(3), Vec3f(1.0f)}});
  EXPECT_EQ(cache.share_of_past(place(3)), 0.5f);
}

TEST(RadianceCache, a_full_cache_takes_no_more_cells_and_keeps_what_it_has) {
  RadianceCache cache(64 * 4);
  update(cache, spread(20000, 0.0f, 4, [](float) { return 1.0f; }));
  EXPECT_LE(cache.cells(), 64u * 4u);
  EXPECT_LE(cache.bytes(), 64u * 4u * RadianceCache::bytes_per_cell() + 64u * 64u * 24u);
  int known = 0;
  for (float x = 0.5f; x < 32.0f; x += 1.0f) {
    const Vec4f light = cache.look_up(place(x, 4.0f));
    if (!(light.w > 0.0f)) continue;
    ++known;
    EXPECT_NEAR(light.x, 1.0f, 1e-5f);
  }
  EXPECT_GT(known, 0);
}

// Tables grow meanwhile: what was known stays so.
TEST(RadianceCache, cells_that_are_new_are_unknown_until_light_is_resolved) {
  RadianceCache cache(kMostWanted);
  EXPECT_FALSE(cache.is_resolved());
  update(cache, spread(2000, 0.0f, 1, [](float) { return 1.0f; }));
  EXPECT_TRUE(cache.is_resolved());
  std::vector<RadianceRecord> more = spread(20000, 0.0f, 2, [](float) { return 1.0f; });
  for (RadianceRecord& record : more) record.place.position = 3.0f * record.place.position + 1000.0f;
  const ThreadPool pool(1);
  cache.add(std::vector<std::span<const RadianceRecord>>{more}, pool);
  CachePoint far = place(3);
  far.position = more.front().place.position;
  EXPECT_EQ(pick(cache, far, Vec2f(0.5f)).w, 0.0f);
  EXPECT_EQ(cache.look_up(far).w, 0.0f);
  EXPECT_EQ(pick(cache, place(3), Vec2f(0.5f)).x, 1.0f);
  cache.resolve(pool);
  EXPECT_EQ(pick(cache, far, Vec2f(0.5f)).x, 1.0f);
}

TEST(RadianceCache, what_was_scattered_as_often_as_may_be_is_left_out_where_that_is_asked) {
  RadianceCache cache(kMostWanted);
  std::vector<RadianceRecord> records = spread(8000, 0.0f, 1, [](float) { return 2.0f; });
  for (std::size_t i = 0; i < records.size(); ++i)
    records[i].deepest = i % 2 == 0 ? 0.5f : -1.0f;  // a quarter of the light, of every other record that is known
  records.push_back({place(500), Vec3f(2.0f)});
  update(cache, records);
  CacheQueries queries;
  queries.set(0, place(3), {0, 0, 1}, Vec2f(0.5f));
  queries.set(1, place(500), {0, 0, 1}, Vec2f(0.5f));  // a single sample is not enough to end paths
  Lanes3 light;
  const LaneMask known = cache.pick(queries, EdgesToPaths::kNone, LookedUp::kWithoutDeepest, light);
  EXPECT_TRUE(known.lane[0]);
  EXPECT_NEAR(light.x[0], 1.5f, 1e-3f);
  EXPECT_FALSE(known.lane[1]);
  const LaneMask all = cache.pick(queries, EdgesToPaths::kNone, LookedUp::kAll, light);
  EXPECT_TRUE(all.lane[0] && all.lane[1]);
  EXPECT_NEAR(light.x[0], 2.0f, 1e-5f);
}

TEST(RadianceCache, the_same_bits_on_any_number_of_threads) {
  const auto answers = [](int threads) {
    const ThreadPool pool(threads);
    RadianceCache cache(kMostWanted);
    for (int f = 0; f < 3; ++f) {
      cache.begin_frame(still, pool);
      std::vector<std::vector<RadianceRecord>> pieces;
      for (unsigned p = 0; p < 8; ++p)
        pieces.push_back(spread(300, 1.0f, p + 100u * static_cast<unsigned>(f), [](float x) { return x; }));
      cache.add(std::vector<std::span<const RadianceRecord>>(pieces.begin(), pieces.end()), pool);
      cache.resolve(pool);
    }
    std::vector<float> light;
    for (float x = 0.0f; x < 32.0f; x += 0.1f) light.push_back(cache.look_up(place(x, 4.0f)).x);
    return light;
  };
  EXPECT_EQ(answers(1), answers(3));
}

TEST(RadianceCache, light_that_is_no_number_is_left_out) {
  RadianceCache cache(kMostWanted);
  update(cache, {{place(3), Vec3f(1.0f)}, {place(3), Vec3f(kInfinity)}, {place(3), {0.0f, std::nanf(""), 0.0f}}});
  EXPECT_NEAR(cache.look_up(place(3)).x, 1.0f, 1e-6f);
}

TEST(RadianceCache, places_far_beyond_any_scene_do_no_harm) {
  RadianceCache cache(kMostWanted);
  CachePoint far = place(1e30f);
  far.size = 1e-30f;
  update(cache, {{far, Vec3f(1.0f)}});
  EXPECT_EQ(pick(cache, far, Vec2f(0.5f)).x, 1.0f);
}

}  // namespace
}  // namespace lippmann
