// Tests views whose samples are seen from several eye positions.
#include "lippmann/optics/angular_filter.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "trace/edge.hpp"
#include "trace/small_scene.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr double kDistance = 20.0, kBaseline = 0.8, kPitch = 0.1;
constexpr int kViews = 5, kWidth = 80, kHeight = 4;

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
  for (Vec3f& position : left.positions) position.x -= 49.97f;
  s.add(left, s.material(glowing(Vec3f(1.0f))));
  return s.scene;
}

TraceParams filtered(int spp) {
  TraceParams params;
  params.spp = spp, params.angular_filter = AngularFilter::kBox;
  return params;
}

TEST(AngularFilter, objects_in_the_displays_plane_stay_sharp) {
  TraceParams plain = filtered(16);
  plain.angular_filter = AngularFilter::kNone;
  EXPECT_EQ(trace(edge_at(0.0f), camera_row(), filtered(16)).film.data, trace(edge_at(0.0f), camera_row(), plain).film.data);
}

// From the distance D = 20 mm, an eye at e sees the edge (X, z) in the display plane at e (1 - m) + X m. Here m = D /
// (D - z) is 1/2. Eyes spread over 0.8 mm shift the edge by 0.8 (1 - m) = 0.4 mm or 4 pixels, so the edge becomes a
// ramp of variance 4^2 / 12. Averages over a pixel and differences of neighbours each add 1/12 to the variance.
TEST(AngularFilter, far_edges_become_ramps) {
  const int spp = 256;
  const Picture sharp = trace(edge_at(-20.0f), camera_row(), {.spp = spp});
  const Picture ramp = trace(edge_at(-20.0f), camera_row(), filtered(spp));
  for (int view = 0; view < kViews; ++view) {
    const double eye = kBaseline * (view - 2), place = 0.5 * kWidth + (0.5 * eye + 0.5 * 0.03) / kPitch;
    // 256 samples resolve the covered area of a pixel to 2/256, which limits the precision of the place and of the
    // variance.
    EXPECT_NEAR(edge_in(sharp, view * kWidth, kWidth).place_px, place, 0.01) << view;
    EXPECT_NEAR(edge_in(ramp, view * kWidth, kWidth).place_px, place, 0.02) << view;
    EXPECT_LE(edge_in(sharp, view * kWidth, kWidth).variance_px2, 0.25 + 0.01)
        << view;  // a (1 - a) for an edge at the position a of its pixel, at most 1/4
    EXPECT_NEAR(edge_in(ramp, view * kWidth, kWidth).variance_px2, 16.0 / 12 + 1.0 / 6, 0.04) << view;
  }
}

TEST(AngularFilter, single_pixels_have_the_same_bits) {
  SmallScene s = busy_scene(5);
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(s.scene, pool);
  device.update(evaluate(s.scene, 0.0), pool);
  TraceParams params = filtered(5);
  params.max_depth = s.scene.max_depth;
  Image whole;
  trace_frame({device, camera_row(), {}}, params, {pool, context}, {whole});
  Image pixels(whole.width, whole.height, 3);
  std::vector<std::uint32_t> all(static_cast<std::size_t>(whole.width * whole.height));
  std::iota(all.begin(), all.end(), 0u);
  trace_pixels({device, camera_row(), {}}, params, all, {pool, context}, pixels, nullptr);
  EXPECT_EQ(pixels.data, whole.data);
}

}  // namespace
}  // namespace lippmann
