#include "denoise/film_views.hpp"

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

constexpr float kRounding = 2e-3f;  ///< single precision of lengths up to 60 mm, in pixels

TEST(FilmViews, sights_find_points_at_their_pixels) {
  for (const Kind& kind : kinds()) {
    const FilmViews views(kind.optics, kind.film);
    const auto width = static_cast<std::uint32_t>(kind.optics.panel.width);
    for (int view = 0; view < views.views(); ++view)
      for (const float z : {-8.0f, 0.0f, 5.0f}) {
        const Vec2i pixel(1, views.size().y - 2);
        const std::uint32_t p = views.row(view, pixel.y)[pixel.x];
        const Ray ray = ray_of_pixel(kind.optics, {static_cast<float>(p % width) + 0.5f, static_cast<float>(p / width) + 0.5f});
        const Vec2f point = Vec2f(ray.origin) + Vec2f(ray.direction) * ((z - ray.origin.z) / ray.direction.z);
        const FilmViews::Sight& sight = views.sight(view);
        const Vec2f place = (point - sight.k * z) / (1.0f - z * views.vergence()) * views.samples_per_mm();
        EXPECT_NEAR(place.x - sight.first.x, static_cast<float>(pixel.x), kRounding) << kind.name << " " << view;
        EXPECT_NEAR(sight.first.y - place.y, static_cast<float>(pixel.y), kRounding) << kind.name << " " << view;
      }
  }
}

}  // namespace
}  // namespace lippmann
