#include "reuse/in_between.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "optics/random_optics.hpp"
#include "trace/small_scene.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

using namespace test;

class Animation {
 public:
  Animation(const Scene& scene, const Optics& optics, const ForwardParams& params, int threads = 1)
      : scene_(scene), optics_(optics), pool_(threads), device_(scene, pool_), maker_(scene, optics, params) {}

  std::function<Affine3f(double)> display = [](double) { return Affine3f{}; };
  InBetweenCounts counts;
  Image memory;

  PointImage traced(double time) {
    PointImage frame;
    frame.moment = moment(time);
    device_.update(frame.moment.resolved, pool_);
    trace_frame({device_, optics_, frame.moment.world_from_display}, trace_params(), {pool_, context_},
                {frame.film, nullptr, &frame.points});
    maker_.prepare(frame, pool_);
    return frame;
  }

  PointImage made(const PointImage& previous, const PointImage& following, double time) {
    PointImage frame;
    frame.film = memory;
    frame.moment = moment(time);
    const TracePixels trace = [&](std::span<const std::uint32_t> pixels, Image& film, PrimaryPoints* points) {
      device_.update(frame.moment.resolved, pool_);
      trace_pixels({device_, optics_, frame.moment.world_from_display}, trace_params(), pixels, {pool_, context_}, film,
                   points);
    };
    counts = maker_.make({previous, following, static_cast<float>(time)}, true, trace, pool_, frame);
    return frame;
  }

  PointImage middle() { return made(traced(0.0), traced(1.0), 0.5); }

 private:
  Moment moment(double time) const { return {evaluate(scene_, time), display(time)}; }
  TraceParams trace_params() const {
    TraceParams params;
    params.max_depth = scene_.max_depth;
    return params;
  }

  const Scene& scene_;
  Optics optics_;
  ThreadPool pool_;
  Context context_;
  DeviceScene device_;
  InBetweenMaker maker_;
};

Optics view32() {
  Optics optics;
  optics.panel = {32, 32, 1.0f};
  optics.model = SingleView{100.0f, {0.0f, 0.0f}};
  return optics;
}

ForwardParams with_fill(MissedFill fill) {
  ForwardParams params;
  params.fill = fill;
  return params;
}

ForwardParams with_mode(SplatMode mode) {
  ForwardParams params;
  params.splat.mode = mode;
  return params;
}

ForwardParams with_sampling(SplatSampling sampling) {
  ForwardParams params;
  params.sampling = sampling;
  return params;
}

constexpr Vec3f kWall(0.5f, 0.25f, 0.125f), kSquare(0.75f);

/// A square of 8 x 8 pixels in front of a wall, both near the plane z = 0. The square is in the middle at times 0 and
/// 1, and `x` pixels further right at time 0.5.
SmallScene square_that_leaves_and_returns(float x) {
  SmallScene s;
  s.add(square(200, -0.001f), s.material(glowing(kWall)));
  s.add(square(4, 0), s.material(glowing(kSquare)), s.moving_node({0, 0, 0}, {0, 0, 0}));
  s.scene.timeline.animations[0].translation = {{0.0, 0.5, 1.0}, {Vec3f(0.0f), Vec3f(x, 0, 0), Vec3f(0.0f)}};
  return s;
}

bool is_inside(int i, int j, int left, int right) { return i >= left && i < right && j >= 12 && j < 20; }

TEST(InBetween, moving_square_leaves_the_hidden_pixels_missed) {
  const SmallScene s = square_that_leaves_and_returns(10.0f);
  Animation animation(s.scene, view32(), with_fill(MissedFill::kBlack));
  const PointImage frame = animation.middle();
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i) {
      const float* pixel = frame.film.pixel(i, j);
      const Vec3f expected = is_inside(i, j, 12, 20) ? Vec3f(0.0f) : is_inside(i, j, 22, 30) ? kSquare : kWall;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(pixel[c], expected[c]) << i << ", " << j;
    }
  EXPECT_EQ(animation.counts.missed, 64u);
  EXPECT_EQ(animation.counts.causes.newly_visible, 64u);
  EXPECT_EQ(animation.counts.causes.not_covered, 0u);
}

TEST(InBetween, previous_film_content_is_overwritten) {
  const SmallScene s = square_that_leaves_and_returns(10.0f);
  for (const MissedFill fill : {MissedFill::kBlack, MissedFill::kInterpolate, MissedFill::kRetrace}) {
    Animation animation(s.scene, view32(), with_fill(fill));
    const Image film = animation.middle().film;
    animation.memory = Image(32, 32, 3);
    for (float& value : animation.memory.data) value = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(animation.middle().film.data, film.data);
  }
}

TEST(InBetween, square_does_not_bleed_into_its_hole) {
  SmallScene s = square_that_leaves_and_returns(8.0f);
  // The wall is so far behind the square that no colour is interpolated between wall and square.
  std::get<Mesh>(s.scene.shapes[0]) = square(200, -30.0f);
  Animation animation(s.scene, view32(), with_fill(MissedFill::kInterpolate));
  const PointImage frame = animation.middle();
  for (int j = 12; j < 20; ++j)
    for (int i = 12; i < 20; ++i)
      for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(frame.film.pixel(i, j)[c], kWall[c]) << i << ", " << j;
}

TEST(InBetween, moving_display_misses_uncovered_columns) {
  SmallScene s;
  s.add(square(200, 0), s.material(glowing(kWall)));
  Animation animation(s.scene, view32(), with_fill(MissedFill::kBlack));
  animation.display = [](double time) { return Affine3f{Mat3f(1.0f), Vec3f(time == 0.5 ? 3.0f : 0.0f, 0, 0)}; };
  const PointImage frame = animation.middle();
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i) ASSERT_EQ(frame.film.pixel(i, j)[0], i < 29 ? kWall.x : 0.0f) << i << ", " << j;
  EXPECT_EQ(animation.counts.causes.not_covered, 3u * 32u);
  EXPECT_EQ(animation.counts.causes.newly_visible, 0u);
}

TEST(InBetween, colours_are_weighted_by_nearness_in_time) {
  SmallScene s;
  s.add(square(200, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 50}).node = s.moving_node({0, 0, 50}, {40, 0, 50});
  Animation animation(s.scene, view32(), {});
  const PointImage a = animation.traced(0.0), b = animation.traced(1.0);
  for (const float time : {0.25f, 0.5f}) {
    const PointImage frame = animation.made(a, b, time);
    // At time 0.25, the following frame has the weight 0.5 + 0.7 (0.25 - 0.5) = 0.325. The factor 0.7 is the preference
    // for the frame that is nearer in time.
    const float weight = time == 0.5f ? 0.5f : 0.325f;
    for (std::size_t k = 0; k < frame.film.data.size(); ++k)
      ASSERT_FLOAT_EQ(frame.film.data[k], (1 - weight) * a.film.data[k] + weight * b.film.data[k]);
  }
  EXPECT_NE(a.film.data, b.film.data);
}

TEST(InBetween, made_frames_have_correct_points) {
  SmallScene s = square_that_leaves_and_returns(10.0f);
  s.scene.timeline.animations[0].translation.values = {{0, 0, 0}, {5, 0, 1}, {10, 0, 2}};
  Animation animation(s.scene, view32(), with_fill(MissedFill::kBlack));
  const PointImage frame = animation.middle(), truth = animation.traced(0.5);
  std::size_t on_square = 0;
  for (std::size_t p = 0; p < frame.points.z.size(); ++p) {
    if (frame.points.object[p] == kMissedObject) continue;
    if (frame.points.object[p] == 1) ++on_square;
    if (frame.points.object[p] != truth.points.object[p]) continue;
    EXPECT_NEAR(frame.points.z[p], truth.points.z[p], 1e-3f) << p;  // the distance of the wall limits the precision
  }
  EXPECT_GT(on_square, 60u);
}

/// Spheres and boxes in front of a checkered wall, with a fixed light. If `moving`, each object has its own motion.
SmallScene busy_scene(bool moving) {
  SmallScene s;
  s.scene.max_depth = 3;
  s.scene.background.horizon = s.scene.background.zenith = {0.2f, 0.3f, 0.5f};
  PhongSurface shiny = matte({0.8f, 0.4f, 0.2f});
  shiny.mirror = 0.3f;
  const int materials[] = {s.material(matte({0.3f, 0.6f, 0.9f})), s.material(shiny)};
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  const auto point = [&] { return Vec3f(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 8; ++i) {
    const Vec3f from = point();
    const int node = s.moving_node(from, moving ? from + 0.3f * point() : from);
    s.add(Spheres{{Vec3f(0.0f), 0.35f}}, materials[i % 2], node);
  }
  for (float x = -2.0f; x < 2.0f; x += 0.4f) s.add(Boxes{{{x, -3, -2}, {x + 0.2f, 3, -1.8f}}}, materials[0]);
  s.point_light({3, 4, 8});
  return s;
}

Optics sheet() {
  Optics optics;
  optics.panel = {96, 60, 4.0f / 96};
  LenticularSheet model;
  model.lens_pitch_mm = 0.25f;
  model.gap_mm = 0.5f;
  model.offset_mm = 0.125f;
  optics.model = model;
  optics.z_front_mm = 10.0f;
  return optics;
}

TEST(InBetween, without_motion_equals_the_traced_frame) {
  const SmallScene s = busy_scene(false);
  OpticsSampler random(6);
  for (int k = 0; k < 12; ++k) {
    const Optics optics = random.any(k);
    for (const SplatMode mode : {SplatMode::kView, SplatMode::kLens}) {
      Animation animation(s.scene, optics, with_mode(mode));
      animation.display = [&](double) { return Affine3f{Mat3f(0.2f), Vec3f(0.0f)}; };
      const PointImage frame = animation.middle();
      EXPECT_EQ(frame.film.data, animation.traced(0.5).film.data) << model_name(optics);
      EXPECT_EQ(animation.counts.missed, 0u) << model_name(optics);
    }
  }
}

TEST(InBetween, threads_do_not_change_bits) {
  const SmallScene s = busy_scene(true);
  for (const MissedFill fill : {MissedFill::kInterpolate, MissedFill::kRetrace}) {
    Animation one(s.scene, sheet(), with_fill(fill), 1);
    const PointImage expected = one.middle();
    ASSERT_GT(one.counts.missed, 0u);
    for (const int threads : {2, 4}) {
      Animation many(s.scene, sheet(), with_fill(fill), threads);
      const PointImage frame = many.middle();
      EXPECT_EQ(frame.film.data, expected.film.data);
      EXPECT_EQ(frame.points.object, expected.points.object);
      EXPECT_EQ(frame.contrast, expected.contrast);
      EXPECT_EQ(many.counts.causes.newly_visible, one.counts.causes.newly_visible);
    }
  }
}

TEST(InBetween, retraced_pixels_equal_the_traced_frame) {
  const SmallScene s = busy_scene(true);
  Animation black(s.scene, sheet(), with_fill(MissedFill::kBlack)), retraced(s.scene, sheet(), with_fill(MissedFill::kRetrace));
  const PointImage hole = black.middle(), frame = retraced.middle(), truth = retraced.traced(0.5);
  std::size_t missed = 0;
  for (std::size_t p = 0; p < frame.points.z.size(); ++p) {
    const bool was_missed = hole.points.object[p] == kMissedObject;
    missed += was_missed;
    EXPECT_EQ(frame.points.object[p], was_missed ? truth.points.object[p] : hole.points.object[p]);
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_EQ(frame.film.data[3 * p + c], (was_missed ? truth : hole).film.data[3 * p + c]) << p;
  }
  EXPECT_GT(missed, 0u);
  EXPECT_EQ(retraced.counts.missed, missed);
  EXPECT_EQ(retraced.counts.retraced, missed);
  EXPECT_EQ(black.counts.retraced, 0u);
}

double squared_error(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.data.size(); ++k) sum += (a.data[k] - b.data[k]) * (a.data[k] - b.data[k]);
  return sum;
}

TEST(InBetween, interpolating_views_beats_whole_pixels) {
  SmallScene s;
  const int material = s.material(glowing(Vec3f(0.8f)));
  for (float x = -3.0f; x < 3.0f; x += 1.0f) s.add(Boxes{{{x, -3, -1}, {x + 0.5f, 3, -0.9f}}}, material);
  const auto error = [&](SplatSampling sampling) {
    Animation animation(s.scene, sheet(), with_sampling(sampling));
    // In the time 0.5 from a key frame to the middle frame, the display moves by 0.175 mm, which is 0.7 of a lens.
    animation.display = [](double time) { return Affine3f{Mat3f(1.0f), Vec3f(0.35 * time, 0, 0)}; };
    return squared_error(animation.middle().film, animation.traced(0.5).film);
  };
  EXPECT_LT(error(SplatSampling::kEpipolar), 0.5 * error(SplatSampling::kPixel));
}

}  // namespace
}  // namespace lippmann
