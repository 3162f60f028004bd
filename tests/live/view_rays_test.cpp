#include "live/view_rays.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

Optics quilt_of(int columns, int rows, Vec2i view) {
  Optics optics;
  optics.panel = {columns * view.x, rows * view.y, 64.0f / static_cast<float>(view.x)};
  optics.model = MultiView{columns, rows, radians(28.0f), false, 150.0f};
  optics.z_front_mm = 150.0f;
  return optics;
}

// 48000 samples for 48 square views are 1000 per view, so a view has sqrt(1000) = 31.6 pixels per side.
TEST(ViewRays, coarse_views_share_the_samples) {
  EXPECT_EQ(coarse_view_size(page_facts(quilt_of(8, 6, {128, 128})), 48e3), Vec2i(31, 31));
  EXPECT_EQ(coarse_view_size(page_facts(quilt_of(8, 6, {128, 64})), 24e3), Vec2i(31, 15));
  EXPECT_EQ(coarse_view_size(page_facts(quilt_of(8, 6, {8, 8})), 48e3), Vec2i(8, 8));
}

TEST(ViewRays, full_views_have_the_panels_rays) {
  PlacedOptics placed;
  placed.optics = with_parallax(quilt_of(3, 2, {5, 4}), 0.5f);
  placed.depth_scale = 0.5f;
  const PageFacts facts = page_facts(placed.optics);
  const Optics rays = view_rays(placed, facts, facts.view_size);
  ASSERT_EQ(film_size(rays), film_size(placed.optics));
  for (int y = 0; y < rays.panel.height; ++y)
    for (int x = 0; x < rays.panel.width; ++x) {
      const Vec2f pixel(x + 0.5f, y + 0.5f);
      const Ray a = ray_of_pixel(rays, pixel), b = ray_of_pixel(placed.optics, pixel);
      EXPECT_LT(glm::length(a.origin - b.origin), 1e-4f);
      EXPECT_LT(glm::length(a.direction - b.direction), 1e-6f);
    }
}

// Hexagonal lenses do not cover whole pixels, so each view is rendered for an eye. The ray through a point of the plane
// z = 0 must come from the eye of its view. A parallax of 0.5 halves the slope of the eye.
TEST(ViewRays, other_optics_use_rays_of_eyes) {
  MicrolensArray array;
  array.packing = LensPacking::kHexagonal;
  array.viewing_distance_mm = 100.0f;
  array.lens_pitch_mm = 1.0f / (1.0f + array.gap_mm / 100.0f);
  PlacedOptics placed;
  placed.optics = {{32, 32, 0.25f}, array, 100.0f};
  placed.optics = with_parallax(placed.optics, 0.5f);
  placed.depth_scale = 0.5f;
  const PageFacts facts = page_facts(placed.optics);
  ASSERT_EQ(facts.panel, PanelPicture::kOwn);
  const Vec2i size(4, 4);
  const Optics rays = view_rays(placed, facts, size);
  for (int view = 0; view < facts.grid.count(); ++view) {
    const Vec2i tile(view % facts.tiles.columns, facts.tiles.rows - 1 - view / facts.tiles.columns);
    const Ray ray = ray_of_pixel(rays, Vec2f(tile * size) + Vec2f(1.5f, 2.5f));
    const Vec2d point = facts.window.point_at({1.5, 2.5}, size);
    const Vec2d slope = 0.5 * eye_of_view(facts, view).slope_at_centre - point / 100.0;
    const Vec3d at_plane = Vec3d(ray.origin) - Vec3d(ray.direction) * double(ray.origin.z / ray.direction.z);
    EXPECT_LT(glm::length(Vec2d(at_plane) - point), 1e-4);
    EXPECT_NEAR(ray.direction.x / ray.direction.z, slope.x, 1e-6);
    EXPECT_NEAR(ray.direction.y / ray.direction.z, slope.y, 1e-6);
  }
}

}  // namespace
}  // namespace lippmann
