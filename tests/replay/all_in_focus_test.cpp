#include "lippmann/replay/all_in_focus.hpp"

#include <gtest/gtest.h>

#include "lippmann/replay/refocus.hpp"
#include "recorded.hpp"

namespace lippmann {
namespace {

RenderedPanel two_depths(const Optics& optics) {
  RenderedPanel panel = test::record(optics, -8.0, test::waves);
  for (int y = 0; y < panel.picture.height; ++y)
    for (int x = 0; x < panel.picture.width; ++x) {
      const Vec2d front = test::meets(optics, x, y, 6.0);
      if (front.x < 0.0) continue;
      const Vec3f c = test::waves(front + Vec2d(3.0, 1.0));
      std::copy_n(&c.x, 3, panel.picture.pixel(x, y));
    }
  return panel;
}

TEST(AllInFocus, halves_take_their_own_depths) {
  for (const Optics& optics : {test::sheet(150.0f), test::lenslets(150.0f)}) {
    const RenderedPanel panel = two_depths(optics);
    const ThreadPool pool(1);
    const Vec2i size = lens_grid(optics);
    AllInFocus sharpest(optics, size);
    Image disagreement;
    for (double z = -12.0; z <= 12.0; z += 2.0) {
      const Image picture = refocus(panel, z, size, pool, &disagreement);
      sharpest.add(picture, disagreement, z);
    }
    // Leaves out 4 lenses at the edges and at the boundary between the planes. The tolerance is one depth step of 2 mm.
    int right = 0, count = 0;
    for (int y = 4; y < size.y - 4; ++y)
      for (int x = 4; x < size.x - 4; ++x) {
        if (std::abs(x - size.x / 2) < 4) continue;
        const double truth = x < size.x / 2 ? -8.0 : 6.0;
        right += std::abs(*sharpest.depth().pixel(x, y) - truth) <= 2.0 ? 1 : 0, ++count;
      }
    EXPECT_GE(right, count * 95 / 100);
    const Vec3f direct = test::waves(display_window(optics).point_at({8.5, 10.5}, size) * (1.0 + 8.0 / 150.0));
    EXPECT_NEAR(sharpest.picture().pixel(8, 10)[1], direct.y, 0.1);
  }
}

TEST(Refocus, rays_agree_at_their_planes_depth) {
  const Optics optics = test::lenslets(150.0f);
  const RenderedPanel panel = test::record(optics, -7.0, test::waves);
  const ThreadPool pool(1);
  const auto mean_disagreement = [&](double z) {
    Image disagreement;
    refocus(panel, z, lens_grid(optics), pool, &disagreement);
    double sum = 0.0;
    for (int y = 5; y < 25; ++y)
      for (int x = 5; x < 25; ++x) sum += *disagreement.pixel(x, y);
    return sum / 400.0;
  };
  const double own = mean_disagreement(-7.0);
  for (const double z : {-20.0, -13.0, 0.0, 5.0, 13.0}) EXPECT_GT(mean_disagreement(z), 1.5 * own) << z;
}

}  // namespace
}  // namespace lippmann
