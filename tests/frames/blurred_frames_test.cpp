#include <gtest/gtest.h>

#include <cmath>

#include "frames/frame.hpp"
#include "frames/made_frames.hpp"
#include "lippmann/frames/renderer.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

TEST(Exposure, times_are_centred_in_their_shares) {
  Timeline timeline;
  timeline.frames_per_second = 10.0;
  const auto times = exposure_times({.spp = 4, .shutter = 0.5f}, timeline, 3);
  ASSERT_EQ(times.size(), 4u);
  // The shutter is open for 0.05 s around frame 3, at 0.3 s. The samples are in the middles of four equal parts.
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(times[i].seconds, 0.3 + 0.05 * ((0.5 + static_cast<double>(i)) / 4 - 0.5), 1e-12);
}

// 33 samples have 32 exposure times, so the first time has two samples.
TEST(Exposure, times_with_more_samples_have_longer_shares) {
  Timeline timeline;
  timeline.frames_per_second = 1.0;
  const auto times = exposure_times({.spp = 33, .shutter = 1.0f}, timeline, 0);
  ASSERT_EQ(times.size(), 32u);
  EXPECT_NEAR(times[0].seconds, 1.0 / 33 - 0.5, 1e-12);
  EXPECT_NEAR(times[1].seconds, 2.5 / 33 - 0.5, 1e-12);
  EXPECT_NEAR(times[31].seconds, 32.5 / 33 - 0.5, 1e-12);
}

constexpr int kWidth = 64;

/// A view 64 pixels wide of a bright surface whose right edge moves right by 25 pixels per second.
struct MovingEdge {
  MovingEdge() {
    const int node = s.moving_node(Vec3f(0.0f), Vec3f(25.0f, 0.0f, 0.0f));
    Mesh left = square(500.0f, 0.0f);
    for (Vec3f& position : left.positions) position.x -= 500.0f;
    s.add(left, s.material(glowing(Vec3f(1.0f))), node);
    s.scene.timeline.frame_count = 3;
    s.scene.timeline.frames_per_second = 2.5;
    placement.placed.optics.panel = {kWidth, 8, 1.0f};
    placement.placed.optics.model = SingleView{100.0f, {0.0f, 0.0f}};
  }

  RenderedFrame frame(const Sampling& sampling, int threads = 2) const {
    Context context;
    context.threads = threads;
    return *Renderer(s.scene, placement, {sampling, {}}, context).frame(1);
  }

  SmallScene s;
  Placement placement;
};

// The edge moves 10 pixels per frame, and the shutter is open for half a frame, so the edge becomes a ramp 5 pixels
// wide around pixel 10. The ramp has the variance 5^2 / 12. The width of the pixels and the differences of neighbouring
// pixels, `steps`, add 1/12 each. Between two of the 32 exposure times, the edge moves by 5 / 32 = 0.16 pixels.
TEST(Exposure, a_moving_edge_becomes_a_ramp) {
  const Image film = MovingEdge().frame({.spp = 64, .shutter = 0.5f}).pictures.film;
  double place = 0.0, variance = 0.0;
  std::vector<double> steps;
  for (int x = 1; x < kWidth; ++x) steps.push_back(static_cast<double>(film.pixel(x - 1, 4)[0] - film.pixel(x, 4)[0]));
  for (std::size_t i = 0; i < steps.size(); ++i) place += steps[i] * static_cast<double>(i + 1);
  for (std::size_t i = 0; i < steps.size(); ++i) variance += steps[i] * std::pow(static_cast<double>(i + 1) - place, 2.0);
  EXPECT_NEAR(place, 0.5 * kWidth + 10.0, 0.1);
  EXPECT_NEAR(variance, 25.0 / 12 + 1.0 / 6, 0.2);
}

TEST(Exposure, is_bit_identical_for_any_thread_count) {
  const Sampling sampling{.integrator = Integrator::kPath, .spp = 5, .lens = {.aperture_mm = 4.0f}, .shutter = 1.0f};
  const MovingEdge edge;
  EXPECT_EQ(edge.frame(sampling, 1).pictures.film.data, edge.frame(sampling, 3).pictures.film.data);
}

TEST(Exposure, alpha_averages_all_times) {
  const RenderedFrame frame = MovingEdge().frame({.spp = 32, .shutter = 1.0f, .transparent = true});
  // With the shutter open for a whole frame, the edge moves from 5 to 15 pixels right of the middle, so it covers the
  // pixel at 10 half of the time.
  EXPECT_NEAR(frame.pictures.aovs[Aov::kAlpha].data[4 * kWidth + kWidth / 2 + 10], 0.5f, 0.15f);
  EXPECT_EQ(frame.pictures.aovs[Aov::kAlpha].data[4 * kWidth + kWidth / 2 - 4], 1.0f);
  EXPECT_EQ(frame.pictures.aovs[Aov::kAlpha].data[4 * kWidth + kWidth / 2 + 20], 0.0f);
}

RenderParams blurred_view(ReuseChoice reuse) {
  RenderParams params;
  params.scene.name = "room";
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {2, 1};
  params.optics.size = {128, 48};
  params.sampling.lens.aperture_mm = 20.0f;
  params.reuse.choice = reuse;
  return params;
}

TEST(DepthOfField, copied_frames_equal_traced_frames) {
  const auto films = [](ReuseChoice reuse) {
    RenderParams params = blurred_view(reuse);
    params.scene.name = "teapot";
    params.sampling.spp = 3;
    return make_frames(params, frames_from(3, 6)).films();
  };
  EXPECT_EQ(films(ReuseChoice::kCopy), films(ReuseChoice::kNone));
}

}  // namespace
}  // namespace lippmann
