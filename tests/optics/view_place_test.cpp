#include "optics/view_place.hpp"

#include <gtest/gtest.h>

#include "random_optics.hpp"

namespace lippmann {
namespace {

using test::at_depth;
using test::OpticsSampler;

Vec2f place(const Optics& optics, Vec2f pixel, Vec3f point) {
  return ViewPlaces(optics).place_in_view(ray_of_pixel(optics, pixel), point).value();
}

Vec2f own_place(const Optics& optics, Vec2f pixel) { return place(optics, pixel, at_depth(ray_of_pixel(optics, pixel), 0.0f)); }

std::vector<Optics> all_kinds(unsigned seed) {
  OpticsSampler random(seed);
  return {random.lenticular(false),
          random.lenticular(true),
          random.microlens(LensPacking::kSquare),
          random.microlens(LensPacking::kHexagonal),
          random.multi_view(),
          random.single_view(),
          random.slanted_panel()};
}

TEST(ViewPlace, all_points_of_a_ray_coincide) {
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const Optics& optics : all_kinds(seed)) {
      const Vec2f pixel(0.3f * film_size(optics).x, 0.6f * optics.panel.height);
      const Ray ray = ray_of_pixel(optics, pixel);
      const Vec2f at = own_place(optics, pixel);
      for (const float z : {-40.0f, -3.0f, 5.0f, 50.0f}) {
        const Vec2f there = place(optics, pixel, at_depth(ray, z));
        // The tolerance covers rounding in single precision of rays that begin up to 1000 mm away.
        EXPECT_NEAR(there.x, at.x, 2e-2f) << seed << ": " << optics.model.index() << " at " << z;
        EXPECT_NEAR(there.y, at.y, 2e-2f) << seed << ": " << optics.model.index() << " at " << z;
      }
    }
}

TEST(ViewPlace, neighbours_are_one_sample_apart) {
  Optics sheet{{64, 50, 0.0625f}, LenticularSheet{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = 0.25f}};
  Optics array{{64, 64, 0.0625f}, MicrolensArray{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = {0.25f, 0.25f}}};
  Optics views{{64, 48, 0.5f}, MultiView{.columns = 4, .rows = 2, .pixel_height = 1.5f}};
  Optics single{{64, 48, 0.5f}, SingleView{}};
  for (const auto& [optics, lens] : {std::pair(sheet, Vec2f(8, 1)), {array, {8, 8}}, {views, {1, 1}}, {single, {1, 1}}}) {
    const Vec2f pixel(18.5f, 19.5f);
    const Vec2f at = own_place(optics, pixel), right = own_place(optics, pixel + Vec2f(lens.x, 0)),
                below = own_place(optics, pixel + Vec2f(0, lens.y));
    EXPECT_NEAR(right.x - at.x, 1.0f, 1e-3f) << optics.model.index();
    EXPECT_NEAR(right.y - at.y, 0.0f, 1e-3f) << optics.model.index();
    EXPECT_NEAR(below.x - at.x, 0.0f, 1e-3f) << optics.model.index();
    EXPECT_NEAR(below.y - at.y, 1.0f, 1e-3f) << optics.model.index();
  }
}

// The viewer is 100 mm in front of the lenses, the panel 2 mm behind them. In the plane of the lenses, rows of pixels
// are 100 / 102 of the pixel pitch apart.
TEST(ViewPlace, sheet_rows_meet_at_the_viewer) {
  const Optics sheet{{64, 50, 0.0625f}, LenticularSheet{.gap_mm = 2.0f, .viewing_distance_mm = 100.0f}};
  const Vec2f a = own_place(sheet, {20.5f, 10.5f}), b = own_place(sheet, {20.5f, 40.5f});
  EXPECT_NEAR(b.y - a.y, 30.0f, 1e-3f);
  EXPECT_NEAR(ViewPlaces(sheet).samples_per_mm().y, 1.02 / 0.0625, 1e-6);
}

TEST(ViewPlace, points_behind_the_viewer_have_none) {
  const Optics single{{64, 48, 0.5f}, SingleView{.distance_mm = 100.0f}};
  const Ray ray = ray_of_pixel(single, {20, 20});
  EXPECT_FALSE(ViewPlaces(single).place_in_view(ray, {1, 1, 100}));
  EXPECT_FALSE(ViewPlaces(single).place_in_view(ray, {1, 1, 200}));
}

}  // namespace
}  // namespace lippmann
