// Views through lenses instead of pinholes have a depth of field.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "trace/edge.hpp"
#include "trace/small_scene.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr double kDistance = 20.0, kBaseline = 0.8, kPitch = 0.1, kEdge = 0.03;
constexpr int kViews = 3, kWidth = 120, kHeight = 4, kSamples = 256;

Optics camera_row() {
  Optics optics;
  optics.panel = {kViews * kWidth, kHeight, static_cast<float>(kPitch)};
  optics.model = MultiView{.columns = kViews, .rows = 1, .distance_mm = kDistance, .baseline_mm = kBaseline};
  return optics;
}

/// A glowing half plane at depth z that covers x < 0.03.
Scene edge_at(float z) {
  SmallScene s;
  Mesh left = square(50.0f, z);
  for (Vec3f& position : left.positions) position.x -= 50.0f - static_cast<float>(kEdge);
  s.add(left, s.material(glowing(Vec3f(1.0f))));
  return s.scene;
}

TraceParams through(const ViewLens& lens, int spp = kSamples) {
  TraceParams params;
  params.spp = spp, params.lens = lens;
  return params;
}

struct Focus {
  float z, focal_plane, aperture;
};

class ThinLensEdge : public testing::TestWithParam<Focus> {};

// Eyes at distance D, focal plane f, edge at depth z, aperture A. The circle of confusion has the diameter A |z - f| /
// (D - z) in the plane z = f, and D / (D - f) times as much on the display. Across an edge, light falls off like the
// area of a disc of diameter c, with variance c^2 / 16. Averages over a pixel and differences of neighbours add 1/12
// px^2 each. An eye at e sees the edge (X, z) at e (1 - m) + X m with m = D / (D - z), for any lens.
TEST_P(ThinLensEdge, is_as_wide_as_the_circle_of_confusion) {
  const auto [z, f, aperture] = GetParam();
  const double circle_px = aperture * std::abs(z - f) / (kDistance - z) * kDistance / (kDistance - f) / kPitch;
  const double m = kDistance / (kDistance - z);
  const Picture blurred = trace(edge_at(z), camera_row(), through({aperture, 0.0f, f}), 2);
  for (int view = 0; view < kViews; ++view) {
    const double eye = kBaseline * (view - 1), place = 0.5 * kWidth + (eye * (1.0 - m) + kEdge * m) / kPitch;
    const Edge edge = edge_in(blurred, view * kWidth, kWidth);
    // The noise of 256 stratified samples moves the place by at most 0.06 pixels. The test allows three times this.
    EXPECT_NEAR(edge.place_px, place, 0.2) << view;
    EXPECT_NEAR(edge.variance_px2, circle_px * circle_px / 16.0 + 1.0 / 6.0, 0.03 * circle_px * circle_px / 16.0 + 0.1) << view;
  }
}

// Edge's depth, focal plane and aperture in mm. The circles of confusion have diameters of 20, 20, 33 and 20 pixels.
INSTANTIATE_TEST_SUITE_P(Depths, ThinLensEdge,
                         testing::Values(Focus{-20.0f, 0.0f, 4.0f}, Focus{10.0f, 0.0f, 2.0f}, Focus{-20.0f, 5.0f, 4.0f},
                                         Focus{5.0f, -10.0f, 3.0f}));

TEST(ThinLens, focal_plane_is_as_sharp_as_a_pinhole) {
  for (const float z : {0.0f, -8.0f, 6.0f}) {
    const Image sharp = trace(edge_at(z), camera_row(), through({}, 16)).film;
    const Image focused = trace(edge_at(z), camera_row(), through({4.0f, 0.0f, z}, 16)).film;
    // Rounding may move a sample across the edge, which changes the pixel by 1/16.
    for (std::size_t i = 0; i < sharp.data.size(); ++i) ASSERT_NEAR(focused.data[i], sharp.data[i], 1.5f / 16.0f) << i;
  }
}

TEST(ThinLens, zero_aperture_equals_a_pinhole) {
  const SmallScene s = busy_scene(3);
  TraceParams pinhole;
  pinhole.spp = 4;
  EXPECT_EQ(trace(s.scene, camera_row(), through({0.0f, 0.0f, 5.0f}, 4)).film.data,
            trace(s.scene, camera_row(), pinhole).film.data);
}

// All points of the lens see a plate at the same size, so its blurred picture has as much light as a sharp one.
// Sampling errors of the sharp and the blurred picture are 0.1 % and 0.13 %. The test allows four times the combined
// error.
TEST(ThinLens, blur_keeps_the_light) {
  SmallScene s;
  s.add(square(2.0f, -10.0f), s.material(glowing(Vec3f(1.0f))));
  const Optics view = single_view(64);
  const double sharp = mean(trace(s.scene, view, through({}, 16)).film);
  const double blurred = mean(trace(s.scene, view, through({0.8f, 0.0f, 0.0f}, 16)).film);
  EXPECT_GT(sharp, 0.1);
  EXPECT_NEAR(blurred / sharp, 1.0, 0.007);
}

TEST(ThinLens, threads_do_not_change_bits) {
  const SmallScene s = busy_scene(7);
  const TraceParams params = through({1.5f, 0.0f, 1.0f}, 8);
  EXPECT_EQ(trace(s.scene, camera_row(), params, 1).film.data, trace(s.scene, camera_row(), params, 4).film.data);
}

TEST(ThinLens, single_pixels_have_the_same_bits) {
  SmallScene s = busy_scene(5);
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(s.scene, pool);
  device.update(evaluate(s.scene, 0.0), pool);
  TraceParams params = through({2.0f, 0.0f, -1.0f}, 5);
  params.max_depth = s.scene.max_depth;
  Image whole;
  trace_frame({device, camera_row(), {}}, params, {pool, context}, {whole});
  Image pixels(whole.width, whole.height, 3);
  std::vector<std::uint32_t> all(static_cast<std::size_t>(whole.width * whole.height));
  std::iota(all.begin(), all.end(), 0u);
  trace_pixels({device, camera_row(), {}}, params, all, {pool, context}, pixels, nullptr);
  EXPECT_EQ(pixels.data, whole.data);
}

TEST(ThinLens, partial_samples_make_the_same_frame) {
  SmallScene s = busy_scene(5);
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(s.scene, pool);
  device.update(evaluate(s.scene, 0.0), pool);
  TraceParams params = through({2.0f, 0.0f, -1.0f}, 7);
  params.max_depth = s.scene.max_depth;
  Image whole, shares(1, 1, 3);
  trace_frame({device, camera_row(), {}}, params, {pool, context}, {whole});
  for (int first = 0; first < 3; ++first)
    trace_frame({device, camera_row(), {}}, params, {pool, context}, {shares}, {first, 3});
  ASSERT_EQ(shares.data.size(), whole.data.size());
  for (std::size_t i = 0; i < whole.data.size(); ++i)
    ASSERT_NEAR(shares.data[i], whole.data[i], 1e-5f) << i;  // seven values are summed in another order
}

}  // namespace
}  // namespace lippmann
