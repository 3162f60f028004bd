#include "denoise/view_geometry.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

struct Kind {
  const char* name;
  Optics optics;
  ViewLayout film;
};

std::vector<Kind> kinds() {
  const MultiView quilt{.columns = 3, .rows = 2, .view_cone = 0.5f, .distance_mm = 60.0f, .pixel_height = 1.5f};
  MultiView grid = quilt;
  grid.baseline_mm = 2.0f;
  return {{"sheet",
           {{64, 50, 0.0625f}, LenticularSheet{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = 0.25f}},
           {LayoutKind::kIntegral, {8, 1}, {}}},
          {"array",
           {{32, 32, 0.0625f}, MicrolensArray{.lens_pitch_mm = 0.25f, .gap_mm = 1.0f, .offset_mm = {0.125f, 0.125f}}},
           {LayoutKind::kIntegral, {4, 4}, {}}},
          {"quilt", {{61, 43, 0.25f}, quilt}, {LayoutKind::kQuilt, {6, 1}, {3, 2}}},
          {"cameras", {{60, 40, 0.25f}, grid}, {LayoutKind::kQuilt, {3, 2}, {3, 2}}},
          {"single", {{40, 30, 0.25f}, SingleView{.distance_mm = 60.0f}}, {LayoutKind::kIntegral, {1, 1}, {}}}};
}

Ray ray_of(const Kind& kind, const ViewGeometry& views, int view, Vec2i pixel) {
  const auto index = static_cast<std::size_t>((view * views.view_size().y + pixel.y) * views.view_size().x + pixel.x);
  const std::uint32_t p = views.pixels()[index], width = static_cast<std::uint32_t>(kind.optics.panel.width);
  return ray_of_pixel(kind.optics, {static_cast<float>(p % width) + 0.5f, static_cast<float>(p / width) + 0.5f});
}

Vec3f at_depth(const Ray& ray, float z) { return ray.origin + ray.direction * ((z - ray.origin.z) / ray.direction.z); }

constexpr float kRounding = 2e-3f;  ///< single precision of lengths up to 60 mm; mm and pixels

TEST(ViewGeometry, points_lie_on_the_rays_of_their_pixels) {
  for (const Kind& kind : kinds()) {
    const ViewGeometry views(kind.optics, kind.film);
    for (int view = 0; view < views.views(); ++view)
      for (const float z : {-8.0f, 0.0f, 5.0f}) {
        const Vec2i pixel(1, views.view_size().y - 2);
        const Vec3f expected = at_depth(ray_of(kind, views, view, pixel), z), point = views.point(Vec2f(pixel), z, view);
        EXPECT_NEAR(point.x, expected.x, kRounding) << kind.name << " " << view;
        EXPECT_NEAR(-point.y, expected.y, kRounding) << kind.name << " " << view;
      }
  }
}

TEST(ViewGeometry, other_views_show_a_point_where_their_rays_meet_it) {
  for (const Kind& kind : kinds()) {
    const ViewGeometry views(kind.optics, kind.film);
    for (int from = 0; from < views.views(); ++from)
      for (int to = 0; to < views.views(); ++to)
        for (const float z : {-3.0f, 0.0f, 2.0f}) {
          const Vec2i pixel = views.view_size() / 3;
          const Vec3f point = at_depth(ray_of(kind, views, from, pixel), z);
          const Vec2f there = views.moved(Vec2f(pixel), z, from, to);
          // There is no ray at a place between samples; the point that would be seen at the place is this one.
          const Vec3f seen = views.point(there, z, to);
          EXPECT_NEAR(seen.x, point.x, kRounding) << kind.name << " " << from << " " << to;
          EXPECT_NEAR(-seen.y, point.y, kRounding) << kind.name << " " << from << " " << to;
        }
  }
}

}  // namespace
}  // namespace lippmann
