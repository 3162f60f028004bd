#include "lippmann/layout/precompensate.hpp"

#include <gtest/gtest.h>

#include "lippmann/replay/eye_sampler.hpp"
#include "recorded.hpp"

namespace lippmann {
namespace {

/// Values between 0.2 and 0.8, so that precompensation clips no sample.
Vec3f soft_waves(Vec2d p) { return 0.6f * test::waves(6.0 * p) + 0.2f; }

/// Returns the largest difference between two panels, seen from the centres of all views through every lens in each
/// third row.
double worst_difference(const RenderedPanel& a, double crosstalk_a, const RenderedPanel& b, double crosstalk_b) {
  const EyeSampler sampler_a(a, SampleFilter::kNearest, crosstalk_a), sampler_b(b, SampleFilter::kNearest, crosstalk_b);
  const Window window = display_window(a.optics);
  const Vec2i grid = lens_grid(a.optics);
  const int count = view_counts(a.optics).x;
  double worst = 0.0;
  for (int view = 0; view < count; ++view)
    for (int y = 0; y < grid.y; y += 3)
      for (int x = 0; x < grid.x; ++x) {
        const Viewer viewer = viewer_in_zone(a.optics, (view + 0.5) / count);
        const Vec2d at = window.point_at({x + 0.5, y + 0.5}, grid);
        const Vec3f difference = sampler_a.color(viewer, at) - sampler_b.color(viewer, at);
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(static_cast<double>(difference[c])));
      }
  return worst;
}

TEST(Precompensate, replayed_with_crosstalk_is_the_original_without) {
  for (const Optics& optics : {test::sheet(100.0f), test::lenslets(100.0f), test::quilt()}) {
    const RenderedPanel wanted = test::record(optics, -3.0, soft_waves);
    RenderedPanel shown = wanted;
    const Precompensation done = precompensate(optics, 0.4, "test", shown.picture);
    EXPECT_EQ(done.clipped_share, 0.0);
    // The tolerance covers rounding in the optics, which shifts the centres of views by 1e-4 of a pixel.
    EXPECT_LE(worst_difference(shown, 0.4, wanted, 0.0), 1e-3);
    EXPECT_GE(worst_difference(wanted, 0.4, wanted, 0.0), 0.02);  // without precompensation
  }
}

TEST(Precompensate, residual_bounds_the_visible_error) {
  const Optics optics = test::sheet(100.0f);
  const RenderedPanel wanted =
      test::record(optics, -3.0, [](Vec2d p) { return Vec3f(std::sin(2.0 * p.x) > 0.0 ? 1.0f : 0.0f); });
  RenderedPanel shown = wanted;
  const Precompensation done = precompensate(optics, 0.4, "test", shown.picture);
  EXPECT_GT(done.clipped_share, 0.0);
  const double plain = worst_difference(wanted, 0.4, wanted, 0.0), undone = worst_difference(shown, 0.4, wanted, 0.0);
  EXPECT_LE(undone, done.largest_residual + 1e-3);
  EXPECT_LE(undone, plain + 1e-3);
}

}  // namespace
}  // namespace lippmann
