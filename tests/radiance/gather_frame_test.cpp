// Frames gathered from a cache, whichever lights it holds, against frames of paths.
#include "radiance/gather_frame.hpp"

#include <gtest/gtest.h>

#include <array>

#include "lippmann/image/encode.hpp"
#include "radiance/cornell_box.hpp"
#include "radiance/update_frame.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// A plastic ball and a post on a floor, below a lamp so wide that paths meet it often, a point-like light and a sky that is
/// brighter above.
SmallScene lit_by_all() {
  SmallScene s;
  s.scene.max_depth = 4;
  s.scene.background.horizon = Vec3f(0.05f), s.scene.background.zenith = {0.2f, 0.3f, 0.5f};
  s.scene.background.up = {0.0f, 1.0f, 0.0f};
  s.scene.background.horizon_at = -1.0f, s.scene.background.zenith_at = 1.0f;
  MetallicRoughness plastic, chalk, lamp;
  plastic.metallic = 0.0f, plastic.roughness = 0.4f, plastic.base_color = {0.5f, 0.2f, 0.1f, 1.0f};
  chalk.metallic = 0.0f, chalk.roughness = 1.0f, chalk.base_color = {0.7f, 0.7f, 0.7f, 1.0f};
  lamp.base_color = {0.0f, 0.0f, 0.0f, 1.0f}, lamp.emissive = Vec3f(2.0f);
  s.add(Spheres{{{0.6f, -0.4f, 0.0f}, 0.6f}}, s.material(plastic));
  const int matt = s.material(chalk);
  s.add(Boxes{{{-4.0f, -1.2f, -4.0f}, {4.0f, -1.0f, 4.0f}}, {{-1.0f, -1.0f, -0.3f}, {-0.7f, 0.5f, 0.3f}}}, matt);
  Mesh shade;
  shade.positions = {{-1.5f, 1.6f, -1.5f}, {1.5f, 1.6f, -1.5f}, {1.5f, 1.6f, 1.5f}, {-1.5f, 1.6f, 1.5f}};
  shade.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.add(shade, s.material(lamp));
  s.point_light({2.0f, 3.0f, 3.0f}, Vec3f(1.0f));
  return s;
}

/// With a sun in the sky, too.
SmallScene lit_by_a_sun_and_all() {
  SmallScene s = lit_by_all();
  s.scene.background.map = sunny_sky({0.1f, 0.15f, 0.2f}, {-2.0f, 3.0f, 3.0f}, Vec3f(2.0f));
  return s;
}

/// All of these, and a ball of light, below a tinted ceiling of glass; half of it is seen through a window.
SmallScene lit_through_panes() {
  SmallScene s = lit_by_a_sun_and_all();
  s.point_light({0.0f, 1.8f, 2.0f}, Vec3f(2.0f)).inverse_square = true;
  s.scene.lights.back().radius = 0.3f;
  MetallicRoughness pane;
  pane.base_color = {0.9f, 0.7f, 0.4f, 1.0f}, pane.metallic = pane.roughness = 0.0f, pane.transmission = 1.0f;
  pane.extensions.emplace().volume = Volume{};
  const int glass = s.material(pane);
  for (const auto& corners :
       {std::array{Vec3f(-4.0f, 1.2f, -4.0f), Vec3f(4.0f, 1.2f, 4.0f), Vec3f(4, 1.2f, -4.0f), Vec3f(-4.0f, 1.2f, 4.0f)},
        std::array{Vec3f(-2.0f, -2.0f, 2.5f), Vec3f(0.0f, 2.0f, 2.5f), Vec3f(0.0f, -2.0f, 2.5f), Vec3f(-2.0f, 2.0f, 2.5f)}}) {
    Mesh wall;
    wall.positions.assign(corners.begin(), corners.end());
    wall.triangles = {{0, 1, 2}, {0, 3, 1}};
    s.add(wall, glass);
  }
  return s;
}

/// A scene whose soft light has 16 rounds of updates.
class CachedScene {
 public:
  /// paths_end: those of updates end in the cache where it knows light from the rounds before.
  CachedScene(const Scene& scene, const Optics& optics, LightGroup lights_from, std::uint32_t seed, bool paths_end = false)
      : optics_(optics), device_(scene, pool_, Integrator::kPath), places_(device_.shaded()), beam_(optics, {}) {
    const ResolvedScene resolved = evaluate(scene, 0.0);
    device_.update(resolved, pool_);
    places_.update(resolved);
    cells_.emplace(CacheCells{places_, beam_, 2.0f, lights_from});
    params_.max_depth = scene.max_depth, params_.seed = seed;
    const CacheUpdater updater({device_, optics, {}}, params_);
    for (int round = 0; round < 16; ++round) {
      if (paths_end && round >= 4 && round % 2 == 0) cache_.resolve(pool_);
      rays_.indirect +=
          updater.update({*cells_, cache_, pool_, context_, nullptr, paths_end && round >= 4}, round).rays.indirect;
    }
    cache_.resolve(pool_);
  }

  const RayCounts& rays_of_updates() const { return rays_; }

  RayCounts gather(Image& film, std::span<const std::uint8_t> wanted = {}, const GatherHistory& history = {},
                   const PathMix& mix = {}, Image* alpha = nullptr, NoisyFrame* noisy = nullptr) const {
    return gather_frame({{device_, optics_, {}}, *cells_, cache_}, {params_, {.mix = mix}}, wanted, history, {pool_, context_},
                        {film, alpha, noisy});
  }

 private:
  ThreadPool pool_{1};
  Context context_;
  Optics optics_;
  DeviceScene device_;
  SurfacePlaces places_;
  BeamFootprint beam_;
  std::optional<CacheCells> cells_;
  TraceParams params_;
  RadianceCache cache_{1u << 16};
  RayCounts rays_;
};

Image gathered(const Scene& scene, const Optics& optics, LightGroup lights_from, std::uint32_t seed, bool paths_end = false) {
  Image film;
  CachedScene(scene, optics, lights_from, seed, paths_end).gather(film);
  return film;
}

// Metallic-roughness surfaces without gloss and Phong's are both shaded in lanes. Lamps shine pi times as bright on the latter.
// Rounding aside they have the same paths, so that pixels differ by no more than two of the errors (0.01) that they may have,
// where it tips a decision; a frame's mean differs from that of paths by one error at most.
TEST(GatherFrame, matt_surfaces_of_either_kind_are_alike) {
  const auto ball_of = [](int material, SmallScene& s, float light) {
    s.scene.max_depth = 4;
    s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.3f);
    s.add(Spheres{{{0.0f, 0.0f, 0.0f}, 1.0f}}, material);
    s.add(Boxes{{{-4.0f, -1.2f, -4.0f}, {4.0f, -1.0f, 4.0f}}}, material);
    s.point_light({2.0f, 3.0f, 3.0f}, Vec3f(light));
  };
  MetallicRoughness matt;
  matt.metallic = matt.specular = 0.0f, matt.base_color = {0.6f, 0.6f, 0.6f, 1.0f};
  SmallScene a, b;
  ball_of(a.material(matt), a, kPi);
  ball_of(b.material(matte(Vec3f(0.6f))), b, 1.0f);
  const Image of_a = gathered(a.scene, single_view(48), LightGroup::kLamps, 1),
              of_b = gathered(b.scene, single_view(48), LightGroup::kLamps, 1);
  for (std::size_t i = 0; i < of_a.data.size(); ++i) ASSERT_NEAR(of_a.data[i], of_b.data[i], 0.02f) << i;
  EXPECT_NEAR(mean(of_a), mean(of_b), 1e-3 * mean(of_b));
  EXPECT_NEAR(mean(of_a), mean(trace_paths(a.scene, single_view(48), 64).film), 0.01 * mean(of_b));
}

TEST(GatherFrame, fills_wanted_packets_alone) {
  const SmallScene s = lit_by_all();
  const Optics optics = single_view(48);
  const CachedScene cached(s.scene, optics, LightGroup::kLamps, 1);
  const FramePackets packets = packets_in_frame(PacketSource(optics, {}, TraceParams{}.order, SubPixel{}));
  std::vector<std::uint8_t> wanted(packets.strips * packets.per_strip, 0);
  wanted[5] = wanted[6] = 1;
  Image film(48, 48, 3);
  std::fill(film.data.begin(), film.data.end(), -1.0f);
  Scatter scatter;
  cached.gather(film, wanted, {nullptr, &scatter});
  EXPECT_EQ(std::count_if(film.data.begin(), film.data.end(), [](float v) { return v >= 0.0f; }), 2 * kLanes * 3);
  for (std::size_t p = 0; p < scatter.size(); ++p) EXPECT_EQ(scatter[p] >= 0.0f, film.data[3 * p] >= 0.0f) << p;
}

double code(float linear) { return srgb_from_linear(std::clamp(static_cast<double>(linear), 0.0, 1.0)); }

// Two pictures with nothing in common but the scene differ by twice the squared error of either. Samples are spread more evenly
// than independent ones, and caches differ, too, so that no more than its order is known.
TEST(GatherFrame, tells_the_error_that_pixels_are_expected_to_have) {
  const SmallScene s = lit_by_all();
  double expected[2] = {};
  Image films[2];
  for (const std::uint32_t seed : {0u, 1u})
    CachedScene(s.scene, single_view(48), LightGroup::kLamps, seed)
        .gather(films[seed], {}, {nullptr, nullptr, &expected[seed]});
  double squares = 0.0;
  for (std::size_t i = 0; i < films[0].data.size(); ++i)
    squares += 0.5 * std::pow(code(films[0].data[i]) - code(films[1].data[i]), 2.0);
  squares /= static_cast<double>(films[0].data.size());
  EXPECT_GT(expected[0], 0.3 * squares);
  EXPECT_LT(expected[0], 3.0 * squares);
  EXPECT_NEAR(expected[0], expected[1], 0.3 * expected[0]);
}

TEST(GatherFrame, expects_no_error_where_samples_are_alike) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.3f);
  Image film;
  double expected = 1.0;
  CachedScene(s.scene, single_view(48), LightGroup::kLamps, 1).gather(film, {}, {nullptr, nullptr, &expected});
  EXPECT_NEAR(expected, 0.0, 1e-8);  // rounding
}

/// Root mean square difference of the channels.
double distance(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::pow(static_cast<double>(a.data[i] - b.data[i]), 2.0);
  return std::sqrt(sum / static_cast<double>(a.data.size()));
}

// What a denoiser wants to know of surfaces is the same wherever light comes from; both have as few samples at edges that the
// first two have missed, and what paths are mixed in changes none of it. 64 samples see a diagonal edge to 1/64 or so.
TEST(GatherFrame, tells_a_denoiser_the_surfaces_that_paths_meet) {
  const SmallScene s = lit_by_a_sun_and_all();
  const Optics optics = single_view(48);
  const CachedScene cached(s.scene, optics, LightGroup::kLamps, 1);
  const ThreadPool pool(1);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  TraceParams params;
  params.spp = 64, params.max_depth = s.scene.max_depth;
  NoisyFrame paths;
  FrameAovs none;
  trace_noisy_frame({device, optics, {}}, params, {pool, Context{}}, paths, none);
  for (const int mixed : {0, 1, 4}) {
    Image film, plain;
    NoisyFrame noisy;
    const PathMix mix{mixed, mixed > 0 ? 0.25f : 0.0f};
    cached.gather(plain, {}, {}, mix);
    cached.gather(film, {}, {}, mix, nullptr, &noisy);
    EXPECT_EQ(film.data, plain.data) << mixed;
    for (Image NoisyFrame::*image : {&NoisyFrame::seen, &NoisyFrame::albedo, &NoisyFrame::normal, &NoisyFrame::met}) {
      EXPECT_NEAR(mean(noisy.*image), mean(paths.*image), 0.01 * std::abs(mean(paths.*image)) + 1e-3) << mixed;
      EXPECT_LT(distance(noisy.*image, paths.*image), 0.08) << mixed;
    }
    EXPECT_LT(distance(noisy.z, paths.z), 0.3) << mixed;
  }
}

// Pictures of two seeds differ by the noise of both: by sqrt(2) of it.
TEST(GatherFrame, tells_a_denoiser_how_noisy_it_is) {
  const SmallScene s = lit_by_a_sun_and_all();
  const Optics optics = single_view(48);
  for (const PathMix& mix : {PathMix{}, PathMix{1, 0.5f}, PathMix{4, 0.5f}}) {
    Image film[2];
    NoisyFrame noisy;
    for (const std::uint32_t seed : {1u, 2u})
      CachedScene(s.scene, optics, LightGroup::kLamps, seed).gather(film[seed - 1], {}, {}, mix, nullptr, &noisy);
    const double is = distance(film[0], film[1]) / std::sqrt(2.0), told = distance(noisy.noise, Image(48, 48, 3));
    EXPECT_GT(told, 0.6 * is) << mix.samples;
    EXPECT_LT(told, 2.5 * is) << mix.samples;
  }
}

// What is left when the cache's share is taken out of the mix are 16 paths a pixel: their mean, and as much noise.
TEST(GatherFrame, mixes_paths_in_by_their_weight) {
  const SmallScene s = lit_by_all();
  const Optics optics = single_view(48);
  const CachedScene cached(s.scene, optics, LightGroup::kLamps, 1);
  Image alone, mixed, alpha_alone(48, 48, 1), alpha_mixed(48, 48, 1), open;
  const RayCounts without = cached.gather(alone), with = cached.gather(mixed, {}, {}, {16, 0.25f});
  EXPECT_EQ(with.primary - without.primary, 48u * 48u * 16u);
  Image rest = mixed;
  for (std::size_t i = 0; i < rest.data.size(); ++i) rest.data[i] = (mixed.data[i] - 0.75f * alone.data[i]) / 0.25f;
  const Image truth = trace_paths(s.scene, optics, 1024).film, paths = trace_paths(s.scene, optics, 16).film;
  EXPECT_NEAR(mean(rest), mean(truth), 0.01 * mean(truth));
  const auto noise = [&](const Image& film) {
    double sum = 0.0;
    for (std::size_t i = 0; i < film.data.size(); ++i) sum += std::pow(static_cast<double>(film.data[i] - truth.data[i]), 2);
    return sum;
  };
  EXPECT_NEAR(noise(rest), noise(paths), 0.3 * noise(paths));
  // Alpha, where a pixel's edge is met by some samples, is mixed likewise.
  cached.gather(open, {}, {}, {}, &alpha_alone);
  cached.gather(open, {}, {}, {16, 0.25f}, &alpha_mixed);
  for (std::size_t i = 0; i < alpha_alone.data.size(); ++i) ASSERT_NEAR(alpha_mixed.data[i], alpha_alone.data[i], 0.25f) << i;
  EXPECT_NEAR(mean(alpha_mixed), mean(alpha_alone), 0.005);
  EXPECT_NE(alpha_mixed.data, alpha_alone.data);
}

// What is measured of some packets is true of the frame: the same paths are mixed in.
TEST(GatherFrame, wanted_packets_get_the_paths_that_they_have_in_the_frame) {
  const SmallScene s = lit_by_all();
  const Optics optics = single_view(48);
  const CachedScene cached(s.scene, optics, LightGroup::kLamps, 1);
  const FramePackets packets = packets_in_frame(PacketSource(optics, {}, TraceParams{}.order, SubPixel{}));
  std::vector<std::uint8_t> wanted(packets.strips * packets.per_strip, 0), none;
  wanted[5] = wanted[70] = 1;
  const auto paths_of = [&](const std::vector<std::uint8_t>& of) {
    Image alone(48, 48, 3), mixed(48, 48, 3);
    cached.gather(alone, of);
    cached.gather(mixed, of, {}, {4, 0.5f});
    for (std::size_t i = 0; i < mixed.data.size(); ++i) mixed.data[i] = 2.0f * mixed.data[i] - alone.data[i];
    return mixed;
  };
  const Image some = paths_of(wanted), whole = paths_of(none);
  int compared = 0;
  for (std::size_t i = 0; i < some.data.size(); ++i) {
    if (some.data[i] == 0.0f) continue;
    ++compared;
    EXPECT_NEAR(some.data[i], whole.data[i], 1e-5f * (1.0f + whole.data[i])) << i;
  }
  EXPECT_EQ(compared, 2 * kLanes * 3);
}

// Scatter of a hundred times the error, squared, asks for (100^2)^(1 / 2.6) = 35 samples of every pixel, and gets 64.
TEST(GatherFrame, takes_the_frame_before_at_its_word) {
  const SmallScene s = lit_by_all();
  const CachedScene cached(s.scene, single_view(48), LightGroup::kLamps, 1);
  Image film;
  const Scatter before(48 * 48, 1.0f);  // error 0.01
  EXPECT_EQ(cached.gather(film, {}, {&before, nullptr}).primary, 48u * 48u * 64u);
  EXPECT_LT(cached.gather(film).primary, 48u * 48u * 16u);
}

TEST(Scatter, is_half_its_own_and_half_that_of_those_near_by) {
  const ThreadPool pool(1);
  const Optics optics = single_view(9);
  Scatter one(81, 0.0f);
  one[4 * 9 + 4] = 25.0f;
  const Scatter smooth = smoothed(one, optics, pool);
  // Five pixels across and five down; a single view has no neighbour, and its columns beside count twice.
  EXPECT_FLOAT_EQ(smooth[4 * 9 + 4], 0.5f * 25.0f + 0.5f * 25.0f / 25.0f);
  EXPECT_FLOAT_EQ(smooth[6 * 9 + 5], 0.5f * 25.0f * (2.0f / 5.0f) * (1.0f / 5.0f));
  EXPECT_EQ(smooth[7 * 9 + 4], 0.0f);
}

TEST(Scatter, that_is_not_known_does_not_count) {
  const ThreadPool pool(1);
  Scatter one(81, -1.0f);
  one[4 * 9 + 4] = 25.0f;
  const Scatter smooth = smoothed(one, single_view(9), pool);
  EXPECT_FLOAT_EQ(smooth[6 * 9 + 5], 25.0f);
  EXPECT_LT(smooth[0], 0.0f);
  EXPECT_TRUE(smoothed({}, single_view(9), pool).empty());
}

TEST(FeedFrame, scarce_places_are_found_and_fed_until_there_is_enough) {
  SmallScene s = lit_by_all();
  const Optics optics = single_view(48);
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(s.scene, pool, Integrator::kPath);
  const ResolvedScene resolved = evaluate(s.scene, 0.0);
  device.update(resolved, pool);
  SurfacePlaces places(device.shaded());
  places.update(resolved);
  const BeamFootprint beam(optics, {});
  const CacheCells cells{places, beam};
  RadianceCache cache(1u << 16);
  const UpdateTarget target{cells, cache, pool, context};
  const CacheUpdater updater({device, optics, {}}, {});
  const auto count = [](const PacketGroups& groups) {
    std::size_t all = 0;
    for (const auto& of_strip : groups) all += of_strip.size();
    return all;
  };
  constexpr float kEnough = 3.0f;
  PacketGroups at_first;
  add_sparse_groups(updater.update(target, 0), cache, kEnough, at_first);
  EXPECT_GT(count(at_first), 0u);
  const UpdateRound second = updater.update_sparse(target, 1, kEnough, at_first);
  EXPECT_GT(second.records(), 100u);
  PacketGroups still;
  add_sparse_groups(second, cache, kEnough, still);
  EXPECT_GT(count(still), 0u);
  for (int round = 2; round < 64; ++round) updater.update_sparse(target, round, kEnough, at_first);
  // But for cells that are seldom met, there is enough now.
  const UpdateRound last = updater.update_sparse(target, 64, kEnough, at_first);
  EXPECT_LT(last.records(), second.records() / 10);
  PacketGroups at_last, scarce;
  add_sparse_groups(last, cache, kEnough, at_last);
  EXPECT_LT(count(at_last), count(at_first) / 2);
  add_sparse_groups(updater.update(target, 65), cache, kEnough, scarce);
  EXPECT_LT(count(scarce), count(at_first) / 2);
}

// A box that holds the scene is passed by all rays, and one within the floor by none.
TEST(FeedFrame, light_may_have_changed_where_rays_pass_what_has_moved) {
  SmallScene s = lit_by_all();
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(s.scene, pool, Integrator::kPath);
  const ResolvedScene resolved = evaluate(s.scene, 0.0);
  device.update(resolved, pool);
  SurfacePlaces places(device.shaded());
  places.update(resolved);
  const BeamFootprint beam(single_view(48), {});
  const CacheCells cells{places, beam};
  const Optics optics = single_view(48);
  const CacheUpdater updater({device, optics, {}}, {});
  const auto cached = [&](const Bounds3f& bounds) {
    RadianceCache cache(1u << 16);
    const TouchProbe moved(device.shaded(), {{bounds, 0}});
    return updater.update({cells, cache, pool, context, &moved}, 0);
  };
  const UpdateRound all = cached({Vec3f(-9.0f), Vec3f(9.0f)});
  std::size_t changed = 0;
  for (const CacheRecords& strip : all.strips)
    for (const RadianceRecord& r : strip.records) changed += r.changed_light + r.changed_share > 0.0f;
  EXPECT_GT(changed, all.records() * 95 / 100);  // but for paths that end where they begin
  for (const CacheRecords& strip : cached({Vec3f(-1.0f, -1.15f, -1.0f), Vec3f(1.0f, -1.05f, 1.0f)}).strips)
    for (const RadianceRecord& r : strip.records) EXPECT_EQ(r.changed_light + r.changed_share, 0.0f);
}

// Twelve renders each: |t| of the mean's difference below 4, which chance exceeds once in 1,500 tests of 22 degrees of freedom;
// 0.3 % are allowed for what cells blur. Where paths that feed the cache meet the lamp although it was asked, and it counts
// twice, the mean is 1.5 % higher; with the sky, 14 %.
/// Renders of many seeds, of paths and gathered, have the same mean.
void expect_the_mean_of_paths(const SmallScene& s, LightGroup from, bool paths_end) {
  constexpr int kRenders = 12;
  double mean_of[2] = {0.0, 0.0}, square_of[2] = {0.0, 0.0};
  for (std::uint32_t seed = 0; seed < kRenders; ++seed) {
    TraceParams params;
    params.seed = 100 + seed;
    const double means[2] = {mean(trace_paths(s.scene, single_view(48), 32, params).film),
                             mean(gathered(s.scene, single_view(48), from, seed, paths_end))};
    for (int k = 0; k < 2; ++k) mean_of[k] += means[k] / kRenders, square_of[k] += means[k] * means[k] / kRenders;
  }
  const auto variance = [&](int k) { return (square_of[k] - mean_of[k] * mean_of[k]) / (kRenders - 1); };
  EXPECT_LT(std::abs(mean_of[0] - mean_of[1]), 4.0 * std::sqrt(variance(0) + variance(1)) + 0.003 * mean_of[0])
      << mean_of[0] << " and " << mean_of[1];
}

class GatheredLights : public testing::TestWithParam<std::tuple<SmallScene (*)(), LightGroup>> {};

TEST_P(GatheredLights, have_the_mean_of_paths_whether_they_are_cached_or_asked) {
  expect_the_mean_of_paths(std::get<0>(GetParam())(), std::get<1>(GetParam()), false);
}

class EndedPaths : public testing::TestWithParam<std::tuple<SmallScene (*)(), LightGroup>> {};

TEST_P(EndedPaths, have_the_mean_of_paths) {
  expect_the_mean_of_paths(std::get<0>(GetParam())(), std::get<1>(GetParam()), true);
}
INSTANTIATE_TEST_SUITE_P(GatherFrame, EndedPaths,
                         testing::Combine(testing::Values(cornell_box, lit_by_all, lit_through_panes),
                                          testing::Values(LightGroup::kSky, LightGroup::kEnd)));

// Paths that end in light which has been scattered as often as paths may be already would make a box of shining walls brighter
// with every round that is resolved.
TEST(EndedPaths, are_scattered_no_more_often_than_others) {
  const SmallScene s = shining_box(3);
  const Optics optics = single_view(48);
  const CachedScene whole(s.scene, optics, LightGroup::kSky, 1), ended(s.scene, optics, LightGroup::kSky, 1, true);
  Image film_of_whole, film_of_ended;
  whole.gather(film_of_whole);
  ended.gather(film_of_ended);
  const double expected = mean(film_of_whole);
  EXPECT_NEAR(mean(film_of_ended), expected, 0.01 * expected);  // else 12 % brighter
  EXPECT_LT(ended.rays_of_updates().indirect, whole.rays_of_updates().indirect);
}

INSTANTIATE_TEST_SUITE_P(GatherFrame, GatheredLights,
                         testing::Combine(testing::Values(lit_by_all),
                                          testing::Values(LightGroup::kLamps, LightGroup::kSky, LightGroup::kEnd)));
INSTANTIATE_TEST_SUITE_P(GatherFrameBelowASun, GatheredLights,
                         testing::Combine(testing::Values(lit_by_a_sun_and_all),
                                          testing::Values(LightGroup::kLamps, LightGroup::kSky, LightGroup::kEnd)));

INSTANTIATE_TEST_SUITE_P(GatherFrameThroughPanes, GatheredLights,
                         testing::Combine(testing::Values(lit_through_panes),
                                          testing::Values(LightGroup::kLamps, LightGroup::kSky, LightGroup::kEnd)));

// A floor below a sun of irradiance 2 at an angle, and a sky of 0.25: radiance 2 cos / pi + 0.25. The squares' shares of the
// sky that the texel takes are too small to count.
TEST(GatherFrame, a_floor_below_a_sun_has_its_irradiance_by_paths_and_from_the_cache) {
  SmallScene s;
  s.scene.max_depth = 3;
  const Vec3f toward = glm::normalize(Vec3f(-1.0f, 0.5f, 2.0f));
  s.scene.background.map = sunny_sky(Vec3f(0.25f), toward, Vec3f(2.0f));
  s.add(square(3, 0), s.material(matte(Vec3f(1.0f))));
  const double expected = 2.0 * static_cast<double>(toward.z) / M_PI + 0.25;
  // The sun's texel is up to 0.7 degrees away from `toward`: 1 % of its light at this angle.
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(32), 256).film), expected, 0.01 * expected);
  for (const LightGroup from : {LightGroup::kSun, LightGroup::kLamps, LightGroup::kEnd})
    EXPECT_NEAR(mean(gathered(s.scene, single_view(32), from, 1)), expected, 0.01 * expected);
}

// A post of half a unit before a floor: its shadow's edges cross all rows. Cells of two samples blur them where they hold the
// sun; where it is asked, a row of pixels is that of paths but for the noise that it may have: samples of error 0.01, whose
// error is a little more at edges.
TEST(GatherFrame, the_shadows_of_a_sun_are_as_sharp_as_those_of_paths) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.scene.background.map = sunny_sky(Vec3f(0.1f), {-1.0f, 0.0f, 1.0f}, Vec3f(3.0f));
  s.add(square(4, 0), s.material(matte(Vec3f(0.8f))));
  s.add(Boxes{{{-0.7f, -4.0f, 0.3f}, {-0.2f, 4.0f, 0.6f}}}, s.material(matte(Vec3f(0.1f))));
  const Image paths = trace_paths(s.scene, single_view(64), 1024).film;
  const auto error = [&](LightGroup from) {
    const Image film = gathered(s.scene, single_view(64), from, 1);
    double squares = 0.0;
    for (int x = 0; x < 64; ++x)
      squares += std::pow(
          std::sqrt(static_cast<double>(film.pixel(x, 32)[0])) - std::sqrt(static_cast<double>(paths.pixel(x, 32)[0])), 2);
    return std::sqrt(squares / 64.0);
  };
  EXPECT_LT(error(LightGroup::kLamps), 0.015);
  EXPECT_GT(error(LightGroup::kSun), 0.025);
}

}  // namespace
}  // namespace lippmann
