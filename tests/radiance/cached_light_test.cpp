// Frames of cached light against frames of paths.
#include "radiance/cached_light.hpp"

#include <gtest/gtest.h>

#include "radiance/cornell_box.hpp"

namespace lippmann {
namespace {

using namespace test;

struct Frames {
  std::vector<Image> films;
  std::vector<CachedLightReport> reports;
};

/// Frames 0 ... count - 1 of `per_second` a second, the history beginning at frame `from`.
struct FrameRange {
  int count;
  int from = 0;
  double per_second = 25.0;
};

Frames cached(const Scene& scene, const Optics& optics, const FrameRange& range, TraceParams params = {}, int threads = 1,
              CachedLightGoal goal = {}) {
  const ThreadPool pool(threads);
  const Context context;
  DeviceScene device(scene, pool, Integrator::kPath);
  CachedLightTracer tracer(device);
  params.max_depth = scene.max_depth;
  params.spp = std::max(params.spp, 64);
  goal.frames = 16;
  Frames frames;
  for (int f = range.from; f < range.count; ++f) {
    const ResolvedScene resolved = evaluate(scene, f / range.per_second);
    device.update(resolved, pool);
    params.frame = static_cast<std::uint32_t>(f);
    // A box around all: of what moves in these scenes nothing is known but that it does.
    std::vector<HorizonBox> moving;
    if (f > range.from && !scene.timeline.animations.empty()) moving.push_back({{Vec3f(-kInfinity), Vec3f(kInfinity)}, 0});
    frames.reports.push_back(
        tracer.trace({device, optics, {}}, resolved, params, goal, moving, {pool, context}, {frames.films.emplace_back()}));
  }
  return frames;
}

double mean_of(const Image& film, int first_row, int rows) {
  double sum = 0.0;
  const auto row = static_cast<std::size_t>(3 * film.width);
  for (std::size_t i = row * static_cast<std::size_t>(first_row); i < row * static_cast<std::size_t>(first_row + rows); ++i)
    sum += static_cast<double>(film.data[i]);
  return sum / static_cast<double>(row * static_cast<std::size_t>(rows));
}

// The picture in eight bands, each of eight renders: |t| of Welch's test below 4.5, which chance exceeds once in 2,000 tests of
// 14 degrees of freedom. Bias of 0.5 %, for what cells blur, is allowed for. The outermost bands are left out: they hold the
// box's front edges, where the number of a pixel's samples depends on what the first ones met, which draws means to it.
TEST(CachedLight, a_diffuse_box_has_the_mean_light_of_paths) {
  const SmallScene s = cornell_box();
  constexpr int kRenders = 8, kBands = 8, kRows = 64 / kBands;
  std::vector<std::vector<double>> paths(kBands), from_cache(kBands);
  for (std::uint32_t seed = 0; seed < kRenders; ++seed) {
    TraceParams params;
    params.seed = seed;
    const Picture p = trace_paths(s.scene, single_view(64), 32, params);
    const Frames c = cached(s.scene, single_view(64), {2}, params, 1, {.error = {.squared = 4e-4f}});
    ASSERT_FALSE(c.reports.back().traced);
    for (int b = 0; b < kBands; ++b) {
      paths[static_cast<std::size_t>(b)].push_back(mean_of(p.film, b * kRows, kRows));
      from_cache[static_cast<std::size_t>(b)].push_back(mean_of(c.films.back(), b * kRows, kRows));
    }
  }
  const auto moments = [](const std::vector<double>& v) {
    double m = 0.0, q = 0.0;
    for (const double x : v) m += x / static_cast<double>(v.size());
    for (const double x : v) q += (x - m) * (x - m) / static_cast<double>(v.size() - 1);
    return std::pair(m, q / static_cast<double>(v.size()));
  };
  for (std::size_t b = 1; b + 1 < kBands; ++b) {
    const auto [m0, v0] = moments(paths[b]);
    const auto [m1, v1] = moments(from_cache[b]);
    EXPECT_LT(std::abs(m0 - m1), 4.5 * std::sqrt(v0 + v1) + 0.005 * m0) << "band " << b << ": " << m0 << " and " << m1;
  }
}

TEST(CachedLight, things_of_any_kind_vanish_in_a_white_furnace) {
  MetallicRoughness chalk, metal, glass;
  chalk.metallic = 0.0f, chalk.roughness = 0.6f;
  metal.roughness = 0.3f;
  glass.metallic = 0.0f, glass.roughness = 0.0f, glass.transmission = 1.0f;
  PhongSurface half = matte(Vec3f(0.6f));
  half.mirror = 0.4f;
  for (int kind = 0; kind < 4; ++kind) {
    SmallScene s;
    s.scene.max_depth = 64;
    surround(s, Vec3f(1.0f));
    const int material = kind == 0   ? s.material(chalk)
                         : kind == 1 ? s.material(metal)
                         : kind == 2 ? s.material(glass)
                                     : s.material(half);
    s.add(Spheres{{{0, 0, 0}, 1.0f}, {{1.2f, 0.5f, 0.8f}, 0.5f}}, material);
    const Frames frames = cached(s.scene, single_view(64), {2}, {}, 1, {.error = {.squared = 1e-4f}});
    EXPECT_FALSE(frames.reports.back().traced) << kind;
    EXPECT_NEAR(mean(frames.films.back()), 1.0, 0.005) << kind;
  }
}

// Squares of 0.2 and 0.8 below a sky of 1, each 8 pixels wide and as wide as the smallest cells: were they blurred by those,
// errors would be as large as their contrast. A tenth of it is left to the samples of a few pixels on edges.
TEST(CachedLight, textures_stay_as_sharp_as_they_are) {
  SmallScene s;
  s.scene.max_depth = 2;
  surround(s, Vec3f(1.0f));
  Texture checks;
  checks.width = checks.height = 8;
  checks.srgb = false;
  for (int i = 0; i < 64; ++i)
    for (int c = 0; c < 4; ++c) checks.rgba.push_back(c == 3 ? 255 : (i + i / 8) % 2 ? 204 : 51);
  s.scene.textures.push_back(checks);
  PhongSurface paper = matte(Vec3f(1.0f));
  paper.texture = 0;
  s.add(square(2, 0), s.material(paper));
  const Frames frames = cached(s.scene, single_view(64), {1}, {}, 1, {.error = {.squared = 1e-5f}});
  ASSERT_FALSE(frames.reports.back().traced);
  const Picture paths = trace_paths(s.scene, single_view(64), 1024);
  int off = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) off += std::abs(frames.films[0].pixel(x, y)[1] - paths.at(x, y).y) > 0.06f;
  EXPECT_LE(off, 8);  // there are 4096 pixels
}

/// The pixels of a picture that differ by a tenth or more from the one on their right or below.
std::vector<Vec2i> edges_of(const Image& picture) {
  std::vector<Vec2i> edges;
  for (int y = 0; y + 1 < picture.height; ++y)
    for (int x = 0; x + 1 < picture.width; ++x)
      if (std::abs(picture.pixel(x, y)[1] - picture.pixel(x + 1, y)[1]) > 0.1f ||
          std::abs(picture.pixel(x, y)[1] - picture.pixel(x, y + 1)[1]) > 0.1f)
        edges.push_back({x, y});
  return edges;
}

double squared_error(const Image& picture, const Image& truth, const std::vector<Vec2i>& pixels) {
  double squares = 0.0;
  for (const Vec2i p : pixels)
    squares += std::pow(static_cast<double>(picture.pixel(p.x, p.y)[1] - truth.pixel(p.x, p.y)[1]), 2);
  return squares / static_cast<double>(pixels.size());
}

// A bright square on edge in a box whose soft light takes next to no samples: the mean of all pixels is as good as that of
// paths with the fewest, and silhouettes would be jagged, with ten times the squared error of those of paths in the first frame
// and four times in the third.
TEST(CachedLight, silhouettes_are_about_as_smooth_as_those_of_paths) {
  SmallScene s = cornell_box();
  Mesh tilted = square(0.8f, 1.0f);
  for (Vec3f& p : tilted.positions) p = {0.9f * p.x - 0.4359f * p.y, 0.4359f * p.x + 0.9f * p.y, p.z};
  s.add(tilted, s.material(glowing(Vec3f(1.0f))));
  const Optics optics = single_view(96);
  const Image truth = trace_paths(s.scene, optics, 512).film;
  const std::vector<Vec2i> edges = edges_of(truth);
  ASSERT_GT(edges.size(), 200u);
  const Frames frames = cached(s.scene, optics, {3});
  ASSERT_FALSE(frames.reports.back().traced);
  const double of_paths = squared_error(trace_paths(s.scene, optics, 64).film, truth, edges);
  EXPECT_LT(squared_error(frames.films.front(), truth, edges), 3.0 * of_paths);
  EXPECT_LT(squared_error(frames.films.back(), truth, edges), 2.0 * of_paths);
}

// The glowing square before the wall is hidden from the camera: it is seen by the light that it sheds alone.
TEST(CachedLight, what_is_hidden_from_cameras_sheds_its_light) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(3, -1), s.material(matte(Vec3f(0.5f))));
  const int lamp = add_lamp_facing_down(s, 0.5f, 0, Vec3f(1.0f));
  s.scene.instances[static_cast<std::size_t>(lamp)].hidden_from_cameras = true;
  const Frames frames = cached(s.scene, single_view(64), {2}, {}, 1, {.error = {.squared = 1e-4f}});
  ASSERT_FALSE(frames.reports.back().traced);
  const Image truth = trace_paths(s.scene, single_view(64), 1024).film;
  EXPECT_GT(truth.pixel(32, 32)[1], 0.05f);
  for (const int x : {32, 24, 8}) EXPECT_NEAR(frames.films.back().pixel(x, 32)[1], truth.pixel(x, 32)[1], 0.015f) << x;
}

// The mirror at z = 0 shows the glowing square behind the viewer, 12 from the eye, at half its light; a matte frame around it.
TEST(CachedLight, mirrors_show_what_they_reflect_exactly) {
  SmallScene s;
  s.scene.max_depth = 3;
  surround(s, Vec3f(0.25f));
  s.add(square(1, 0), s.material(mirror(0.5f)));
  s.add(square(3, -0.5f), s.material(matte(Vec3f(0.4f))));
  const Frames frames = cached(s.scene, single_view(64), {1}, {}, 1, {.error = {.squared = 1e-4f}});
  ASSERT_FALSE(frames.reports.back().traced);
  EXPECT_FLOAT_EQ(frames.films[0].pixel(32, 32)[0], 0.125f);
  EXPECT_NEAR(frames.films[0].pixel(4, 32)[0], 0.1f, 0.01f);  // the mirror's back hides a little of the sky
}

// A lamp passes over a floor from left to right. Where it was at first, it is dark in the end.
TEST(CachedLight, light_that_moves_away_leaves_nothing_behind) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(3, 0), s.material(matte(Vec3f(0.8f))));
  PhongSurface lamp = matte(Vec3f(0.0f));
  lamp.emission = Vec3f(4.0f);
  Mesh panel = square(0.3f, 0.0f);
  s.add(panel, s.material(lamp), s.moving_node({-1.2f, 0, 0.6f}, {1.2f, 0, 0.6f}));
  s.scene.timeline.frame_count = 11;
  const Frames history = cached(s.scene, single_view(64), {11, 0, 10.0}, {}, 1, {.error = {.squared = 1e-3f}});
  const Frames fresh = cached(s.scene, single_view(64), {11, 10, 10.0}, {}, 1, {.error = {.squared = 1e-3f}});
  ASSERT_FALSE(history.reports.back().traced);
  const Image paths = trace(s.scene, single_view(64), {.spp = 256}, 1, 1.0, {}, Integrator::kPath).film;
  double with_history = 0.0, without = 0.0;
  for (std::size_t i = 0; i < paths.data.size(); ++i) {
    with_history += std::pow(static_cast<double>(history.films.back().data[i] - paths.data[i]), 2);
    without += std::pow(static_cast<double>(fresh.films.back().data[i] - paths.data[i]), 2);
  }
  // Cells may have half as many samples as a history's first frame gives them: twice its error.
  EXPECT_LT(with_history, 2.0 * without + 1e-6);
  const Vec3f left(history.films.back().pixel(12, 32)[0]), left_of_paths(paths.pixel(12, 32)[0]);
  EXPECT_NEAR(left.x, left_of_paths.x, 0.02f);
}

TEST(CachedLight, the_same_bits_on_any_number_of_threads) {
  const SmallScene s = cornell_box();
  const Frames one = cached(s.scene, lenticular_view(), {3}), three = cached(s.scene, lenticular_view(), {3}, {}, 3);
  for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(one.films[f].data, three.films[f].data) << f;
}

TEST(CachedLight, the_error_that_is_asked_for_is_kept) {
  const SmallScene s = cornell_box();
  const Image truth = trace_paths(s.scene, single_view(64), 1024).film;
  for (const float goal : {1e-3f, 2e-4f}) {
    const Frames frames = cached(s.scene, single_view(64), {2}, {}, 1, {.error = {.squared = goal}});
    double squares = 0.0;
    const auto code = [](float v) { return std::pow(static_cast<double>(std::clamp(v, 0.0f, 1.0f)), 1.0 / 2.2); };
    for (std::size_t i = 0; i < truth.data.size(); ++i)
      squares += std::pow(code(frames.films.back().data[i]) - code(truth.data[i]), 2);
    // One block of 16 was measured: not exact, but of that size.
    EXPECT_LT(squares / static_cast<double>(truth.data.size()), 3.0 * static_cast<double>(goal));
  }
}

// For the error that 64 paths have here. That means err by half a code at most, as paths do, is luck in so small a picture.
TEST(CachedLight, fewer_rays_are_traced_than_by_paths) {
  const SmallScene s = cornell_box();
  const Frames frames = cached(s.scene, single_view(128), {2}, {}, 1, {.error = {.squared = 1.2e-4f}});
  ASSERT_FALSE(frames.reports.back().traced);
  const RayCounts paths = trace_paths(s.scene, single_view(128), 64).counts;
  EXPECT_LT(frames.reports.back().rays.total(), paths.total() / 4);
}

/// Mirrors on three walls, and a ball that shines: what they show again and again, cells know too roughly.
SmallScene mirror_box() {
  SmallScene s = cornell_box();
  MetallicRoughness polished;
  polished.metallic = 1.0f, polished.roughness = 0.0f, polished.base_color = {0.9f, 0.9f, 0.9f, 1.0f};
  s.add(Boxes{{{-1.9f, -1.9f, -1.95f}, {1.9f, 1.9f, -1.9f}},
              {{-1.95f, -1.9f, -1.9f}, {-1.9f, 1.9f, 1.9f}},
              {{1.9f, -1.9f, -1.9f}, {1.95f, 1.9f, 1.9f}}},
        s.material(polished));
  PhongSurface lamp = matte(Vec3f(0.0f));
  lamp.emission = Vec3f(2.0f);
  s.add(Spheres{{{0.5f, 1.0f, 0.5f}, 0.6f}}, s.material(lamp));
  return s;
}

/// Mean squared differences of means over 8 x 8 pixels, as they are shown.
double block_error(const Image& film, const Image& truth) {
  double squares = 0.0;
  const int blocks = film.width / 8;
  for (int b = 0; b < blocks * blocks; ++b) {
    double difference = 0.0;
    for (int p = 0; p < 64; ++p) {
      const int x = 8 * (b % blocks) + p % 8, y = 8 * (b / blocks) + p / 8;
      difference += static_cast<double>(std::min(film.pixel(x, y)[0], 1.0f) - std::min(truth.pixel(x, y)[0], 1.0f)) / 64.0;
    }
    squares += difference * difference / (blocks * blocks);
  }
  return squares;
}

TEST(CachedLight, what_cells_are_wrong_about_averages_out_with_that_of_a_few_paths) {
  const SmallScene s = mirror_box();
  const Optics optics = single_view(128);  // with fewer pixels it depends on the seed whether all is traced
  const Frames frames = cached(s.scene, optics, {2}, {}, 1, {});
  ASSERT_FALSE(frames.reports.back().traced);
  const auto paths = trace_paths(s.scene, optics, 64);
  EXPECT_LT(frames.reports.back().rays.total(), 0.9 * static_cast<double>(paths.counts.total()));
  // Twice the error of paths is allowed, and what was measured of it by chance.
  const Image truth = trace_paths(s.scene, optics, 512).film;
  EXPECT_LT(block_error(frames.films.back(), truth), 3.0 * block_error(paths.film, truth));
}

TEST(CachedLight, what_no_cache_can_reach_is_traced_with_as_many_paths_as_it_takes) {
  const SmallScene s = cornell_box();
  const ThreadPool pool(1);
  const Context context;
  const DeviceScene device(s.scene, pool, Integrator::kPath);
  CachedLightTracer tracer(device);
  TraceParams params;
  params.spp = 2;
  Image film;
  const CachedLightReport report = tracer.trace({device, single_view(32), {}}, evaluate(s.scene, 0.0), params,
                                                {.error = {.squared = 1e-9f}}, {}, {pool, context}, {film});
  EXPECT_TRUE(report.traced);
  EXPECT_GE(report.rays.primary, 32u * 32u * 2u * 64u);  // at most 64 times as many
}

// No clock is so fast that pixels take no time, and none so slow that they take a day.
TEST(CachedLight, frames_are_as_good_as_their_time_allows) {
  const SmallScene s = cornell_box();
  const auto report_of = [&](double seconds) {
    return cached(s.scene, single_view(64), {1}, {}, 1, {.seconds = seconds}).reports.back();
  };
  const CachedLightReport none = report_of(1e-6), plenty = report_of(86400.0);
  EXPECT_FALSE(none.traced);
  EXPECT_FALSE(plenty.traced);
  EXPECT_LT(plenty.pixels.squared, 0.5f * none.pixels.squared);
  EXPECT_GT(plenty.rays.total(), 2 * none.rays.total());
}

/// The first two frames of a scene, without what surrounds it.
std::pair<Picture, CachedLightReport> cached_without_surroundings(const Scene& scene, const Optics& optics,
                                                                  float squared_error) {
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(scene, pool, Integrator::kPath);
  CachedLightTracer tracer(device);
  const ResolvedScene resolved = evaluate(scene, 0.0);
  device.update(resolved, pool);
  TraceParams params;
  params.max_depth = scene.max_depth, params.spp = 64;
  Picture picture;
  picture.aovs.want(Aov::kAlpha);
  CachedLightReport report;
  for (; params.frame < 2; ++params.frame)
    report = tracer.trace({device, optics, {}}, resolved, params, {.error = {.squared = squared_error}}, {}, {pool, context},
                          {picture.film, &picture.aovs});
  return {std::move(picture), report};
}

// A ball before surroundings as bright as itself, or as black: its edge shows in alpha alone. Of samples of deviation 1 / 2,
// errors of 0.01 want (50^2)^(1 / 2.6) = 20, and so 32, whose error is 0.5 / 32^0.8 = 0.03; the 192 pixels of 4096 that a
// circle 48 pixels wide crosses make 0.0065 of it.
TEST(CachedLight, alpha_is_that_of_paths_and_colours_are_multiplied_by_it) {
  for (const bool black : {false, true}) {
    SmallScene s;
    s.scene.max_depth = 2;
    surround(s, Vec3f(black ? 0.0f : 1.0f));
    s.add(Spheres{{{0, 0, 0}, 1.5f}}, s.material(black ? matte(Vec3f(0.0f)) : glowing(Vec3f(1.0f))));
    const auto [gathered, report] = cached_without_surroundings(s.scene, single_view(64), 1e-4f);
    ASSERT_FALSE(report.traced);
    Picture paths;
    paths.aovs.want(Aov::kAlpha);
    const ThreadPool pool(1);
    DeviceScene device(s.scene, pool, Integrator::kPath);
    trace_frame({device, single_view(64), {}}, {.spp = 1024, .max_depth = 2}, {pool, Context{}}, {paths.film, &paths.aovs});
    double squares = 0.0;
    int coarse = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const float a = gathered.aovs[Aov::kAlpha].pixel(x, y)[0], expected = paths.aovs[Aov::kAlpha].pixel(x, y)[0];
        squares += std::pow(static_cast<double>(a - expected), 2);
        coarse += std::abs(a - expected) > 0.2f;
        ASSERT_NEAR(gathered.at(x, y).y, black ? 0.0f : a, 1e-5f) << x << ", " << y;
      }
    EXPECT_LT(std::sqrt(squares / (64.0 * 64.0)), 0.01) << black;
    EXPECT_LE(coarse, 4) << black;  // one in 50: of the others no edge was missed
  }
}

// Half of the picture is open, half a square that is lit by the surroundings alone.
TEST(CachedLight, surroundings_that_are_not_seen_light_what_is) {
  SmallScene s;
  s.scene.max_depth = 3;
  surround(s, Vec3f(0.5f));
  s.add(square(1, 0), s.material(matte(Vec3f(0.8f))));
  const auto [picture, report] = cached_without_surroundings(s.scene, single_view(32), 1e-4f);
  ASSERT_FALSE(report.traced);
  EXPECT_NEAR(picture.at(16, 16).x, 0.4f, 0.01f);
  EXPECT_EQ(picture.aovs[Aov::kAlpha].pixel(16, 16)[0], 1.0f);
  EXPECT_EQ(picture.at(2, 2), Vec3f(0.0f));
  EXPECT_EQ(picture.aovs[Aov::kAlpha].pixel(2, 2)[0], 0.0f);
}

TEST(CachedLight, provenance_is_green_at_first_and_blue_where_frames_before_are_known) {
  SmallScene s;
  s.scene.max_depth = 2;
  surround(s, Vec3f(1.0f));
  s.add(square(1, 0), s.material(matte(Vec3f(0.5f))));
  const Frames frames = cached(s.scene, single_view(64), {3}, {}, 1, {.provenance = true});
  const float* first = frames.films[0].pixel(32, 32);
  const float* last = frames.films[2].pixel(32, 32);
  EXPECT_EQ(first[2], 0.0f);
  EXPECT_NEAR(first[1], 0.5f, 0.02f);
  EXPECT_GT(last[2], last[1]);
  EXPECT_EQ(frames.films[0].pixel(2, 2)[0], 1.0f);  // the sky is traced
  EXPECT_EQ(frames.films[0].pixel(2, 2)[1], 0.0f);
}

}  // namespace
}  // namespace lippmann
