#include "lippmann/replay/refocus.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "recorded.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::linear_psnr, test::record, test::seen_directly, test::waves;

float brightest(const Image& picture) { return *std::max_element(picture.data.begin(), picture.data.end()); }

double depth_of_peak(const RenderedPanel& panel, double step, int count) {
  const ThreadPool pool(1);
  double best = 0.0, depth = 0.0;
  for (int i = -count; i <= count; ++i) {
    const double peak = brightest(refocus(panel, i * step, lens_grid(panel.optics), pool));
    if (peak > best) best = peak, depth = i * step;
  }
  return depth;
}

// Depth step dz in mm. A step shifts the outermost views by (p / 2) dz / g, with the lens pitch p and the gap g. For dz
// = g = 2 mm, this is half a lens.
constexpr double kStep = 2.0;

/// Tests depths on both sides of the display. Points nearer than 2 kStep are seen through a single lens, and one ray
/// does not determine a depth.
void expect_peaks_at(const std::function<RenderedPanel(Vec3f)>& recorded) {
  for (int i = -11; i <= 11; ++i) {
    if (std::abs(i) < 2) continue;
    const auto z = static_cast<float>(i * kStep);
    EXPECT_NEAR(depth_of_peak(recorded({0.37f, 0.61f, z}), kStep, 13), z, kStep) << "z = " << z;
  }
}

TEST(Refocus, point_peaks_at_its_depth_through_lenticules) {
  const Optics optics = test::sheet();
  expect_peaks_at([&](Vec3f p) { return test::record_point(optics, p); });
}

TEST(Refocus, point_peaks_at_its_depth_through_lenslets) {
  Optics optics = test::lenslets();
  optics.panel.height = 70;
  expect_peaks_at([&](Vec3f p) { return test::record_point(optics, p); });
}

TEST(Refocus, point_peaks_at_its_depth_elsewhere) {
  for (const Optics& optics :
       {test::sheet(150.0f), test::lenslets(150.0f, LensPacking::kHexagonal), test::sheet(150.0f, 0.25f), test::quilt()})
    for (const float z : {-12.0f, -6.0f, 6.0f, 12.0f})
      EXPECT_NEAR(depth_of_peak(test::record_point(optics, {0.37f, 0.61f, z}), kStep, 9), z, kStep) << optics.model.index();
}

TEST(Refocus, blob_keeps_the_design_viewers_position) {
  const Optics optics = test::lenslets(150.0f);
  const ThreadPool pool(1);
  const Vec2i size = lens_grid(optics);
  const Vec3d point(3.2, -4.1, -11.0);
  const auto blob = [&](Vec2d p) {
    const Vec2d from = p - Vec2d(point);
    return Vec3f(std::exp(-glm::dot(from, from) / 2.0));
  };
  const Image picture = refocus(record(optics, point.z, blob), point.z, size, pool);
  const float half = 0.5f * brightest(picture);
  Vec2d sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double w = std::max(0.0f, picture.pixel(x, y)[0] - half);
      sum += w * Vec2d(x + 0.5, y + 0.5), weight += w;
    }
  // The line from the point at z = -11 mm to the viewer at z = 150 mm meets the display at (3.2, -4.1) * 150 / 161.
  // Lenses and pixels of 0.8 mm show a spot with a sigma of 1 mm, whose centre is exact to 0.1 mm.
  const Vec2d at = display_window(optics).point_at(sum / weight, size);
  EXPECT_NEAR(at.x, 3.2 * 150 / 161, 0.1);
  EXPECT_NEAR(at.y, -4.1 * 150 / 161, 0.1);
}

TEST(Refocus, plane_is_sharp_only_at_its_depth) {
  const Vec3d viewer(0, 0, 150);
  for (const Optics& optics : {test::sheet(150.0f), test::lenslets(150.0f), test::quilt()}) {
    const Vec3d eye = std::holds_alternative<MultiView>(optics.model) ? Vec3d(0, 0, 100) : viewer;
    const ThreadPool pool(1);
    const Vec2i size = lens_grid(optics);
    const double z = -5.0;
    const RenderedPanel panel = record(optics, z, waves);
    const Image truth = seen_directly(optics, size, eye, z, waves);
    // Interpolation over a lens of 1 mm reduces a wave of 0.95 rad/mm by (0.95 * 1)^2 / 12 = 8 %. For the amplitude
    // 0.4, the RMS error is 0.4 * 0.08 / sqrt(2) = 0.023, which is 33 dB.
    EXPECT_GE(linear_psnr(refocus(panel, z, size, pool), truth, 4), 30.0);
    EXPECT_LT(linear_psnr(refocus(panel, 12.0, size, pool), truth, 4), 22.0);
  }
}

TEST(Refocus, threads_do_not_change_a_bit) {
  const RenderedPanel panel = record(test::lenslets(100.0f), 3.0, waves);
  const ThreadPool one(1), three(3);
  EXPECT_EQ(refocus(panel, 7.0, {64, 80}, one).data, refocus(panel, 7.0, {64, 80}, three).data);
}

TEST(Refocus, cancelling_stops_before_the_next_row) {
  const RenderedPanel panel = record(test::lenslets(100.0f), 3.0, waves);
  const ThreadPool pool(2);
  const Image black(64, 80, 3);
  EXPECT_NE(refocus(panel, 7.0, {64, 80}, pool).data, black.data);
  Context context;
  context.cancelled = true;
  EXPECT_EQ(refocus(panel, 7.0, {64, 80}, pool, nullptr, context).data, black.data);
}

TEST(Refocus, invalid_panels_and_sizes_are_refused) {
  const ThreadPool pool(1);
  const RenderedPanel good = test::record_point(test::sheet(), {0.37f, 0.61f, 4.0f});
  const auto message = [&](const auto& spoil, Vec2i size) {
    RenderedPanel panel = good;
    spoil(panel.picture);
    return test::error_message([&] { refocus(panel, 4.0, size, pool); });
  };
  EXPECT_EQ(message([](Image&) {}, {8, 8}), "(no Error)");
  EXPECT_THAT(message([](Image& p) { p.data.pop_back(); }, {8, 8}), testing::HasSubstr("samples"));
  EXPECT_THAT(message([](Image& p) { p = Image(p.width, p.height, 1); }, {8, 8}), testing::HasSubstr("1 channels"));
  EXPECT_THAT(message([](Image& p) { p = Image(3, 3, 3); }, {8, 8}), testing::HasSubstr("the size of the panel"));
  for (const Vec2i size : {Vec2i(-1, 4), Vec2i(8, 0)})
    EXPECT_THAT(message([](Image&) {}, size), testing::HasSubstr("numbers of pixels")) << size.x;
}

TEST(Refocus, invalid_depths_are_refused) {
  const auto message = [](double z) {
    return test::error_message([&] { validate_depth(test::sheet(150.0f), z, "--refocus"); });
  };
  EXPECT_THAT(message(150.0), testing::HasSubstr("not in front of the viewer"));
  EXPECT_THAT(message(std::nan("")), testing::HasSubstr("out of range"));
  Optics one_lens = test::sheet();
  std::get<LenticularSheet>(one_lens.model).lens_pitch_mm = 40.0f;
  EXPECT_THAT(test::error_message([&] { validate_depth(one_lens, 1.0, "--refocus"); }), testing::HasSubstr("no parallax"));
  EXPECT_EQ(message(-1000.0), "(no Error)");
  EXPECT_EQ(message(140.0), "(no Error)");
  EXPECT_EQ(message(149.98), "(no Error)");
  EXPECT_THAT(message(149.99), testing::HasSubstr("too near the viewer"));
}

}  // namespace
}  // namespace lippmann
