#include "denoise/sorted_views.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "kinds.hpp"
#include "layout/film_layout.hpp"

namespace lippmann {
namespace {

constexpr float kRounding = 2e-3f;  ///< in pixels: error of single precision at distances of up to 60 mm

Ray ray_of(const Optics& optics, std::uint32_t pixel) {
  const auto width = static_cast<std::uint32_t>(film_size(optics).x);
  return ray_of_pixel(optics, {static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f});
}

SortedViews all_views(const Optics& optics) { return {optics, {0, film_size(optics).y}}; }

template <class Fn>
void for_each_pixel(const SortedViews& views, const Fn& fn) {
  for (int view = 0; view < views.views(); ++view)
    for (int y = 0; y < views.size().y; ++y)
      for (int x = 0; x < views.size().x; ++x)
        if (const std::uint32_t p = views.row(view, y)[x]; p != SortedViews::kNoPixel) fn(view, x, y, p);
}

/// Returns the number of film pixels in no view and the number in one view. Throws std::out_of_range if a pixel is in
/// several views.
std::array<int, 2> pixels_by_places(const Optics& optics) {
  const Vec2i film = film_size(optics);
  std::vector<std::size_t> places(static_cast<std::size_t>(film.x * film.y));
  for_each_pixel(all_views(optics), [&](int, int, int, std::uint32_t p) { ++places.at(p); });
  std::array<int, 2> pixels{};
  for (const std::size_t n : places) ++pixels.at(n);
  return pixels;
}

TEST(SortedViews, every_pixel_has_one_place) {
  for (const OpticsCase& kind : optics_cases()) EXPECT_EQ(pixels_by_places(kind.optics)[0], 0) << kind.name;
}

TEST(SortedViews, padding_of_a_quilt_has_no_place) {
  const Optics optics{{61, 43, 0.25f}, MultiView{.columns = 3, .rows = 2, .view_cone = 0.5f, .distance_mm = 60.0f}};
  EXPECT_EQ(pixels_by_places(optics)[1], 60 * 42);
}

TEST(SortedViews, views_of_whole_pixels_match_the_layout) {
  for (const OpticsCase& kind : optics_cases()) {
    if (!kind.whole_views) continue;
    const SortedViews views = all_views(kind.optics);
    const ViewLayout layout = film_layout(kind.optics, "test");
    const Vec2i size = view_size(layout, film_size(kind.optics), "test");
    EXPECT_EQ(views.size(), size) << kind.name;
    const std::vector<std::uint32_t> stack = pixels_of_views(layout, size, film_size(kind.optics));
    const std::ptrdiff_t pixels = static_cast<std::ptrdiff_t>(size.x) * size.y;
    std::set<std::vector<std::uint32_t>> expected, sorted;
    for (int view = 0; view < layout.grid.count(); ++view)
      expected.emplace(stack.begin() + view * pixels, stack.begin() + (view + 1) * pixels);
    for (int view = 0; view < views.views(); ++view) sorted.emplace(views.row(view, 0), views.row(view, 0) + pixels);
    EXPECT_EQ(sorted, expected) << kind.name;
  }
}

Vec2f off(const SortedViews& views, const Ray& ray, float z, int view, int x, int y) {
  const Vec2f point = Vec2f(ray.origin) + Vec2f(ray.direction) * ((z - ray.origin.z) / ray.direction.z);
  const SortedViews::Sight& sight = views.sight(view);
  const Vec2f place = (point - sight.k * z) / (1.0f - z * views.vergence()) * views.samples_per_mm();
  return {place.x - sight.first.x - views.shifts()[y] - static_cast<float>(x), sight.first.y - place.y - static_cast<float>(y)};
}

TEST(SortedViews, sights_find_points_at_their_pixels) {
  for (const OpticsCase& kind : optics_cases()) {
    if (!kind.whole_views) continue;
    const SortedViews views = all_views(kind.optics);
    for (const float z : {-8.0f, 0.0f, 5.0f})
      for_each_pixel(views, [&](int view, int x, int y, std::uint32_t p) {
        const Vec2f error = off(views, ray_of(kind.optics, p), z, view, x, y);
        ASSERT_NEAR(error.x, 0.0f, kRounding) << kind.name << " " << view;
        ASSERT_NEAR(error.y, 0.0f, kRounding) << kind.name << " " << view;
      });
  }
}

// Points up to half the depth budget from the display must be mapped to the right pixel or a neighbouring one. If
// pixels are diamond-shaped, a few points are mapped to a neighbouring view.
TEST(SortedViews, sights_are_accurate_to_one_pixel) {
  for (const OpticsCase& kind : optics_cases()) {
    const SortedViews views = all_views(kind.optics);
    if (kind.whole_views || views.views() == 1) continue;
    const float budget = depth_budget_mm(kind.optics);
    for (const float share : {-0.5f, 0.0f, 0.5f}) {
      int pixels = 0, missed = 0;
      for_each_pixel(views, [&](int view, int x, int y, std::uint32_t p) {
        const Vec2f error = glm::abs(off(views, ray_of(kind.optics, p), share * budget, view, x, y));
        ++pixels, missed += error.x > 1.0f + kRounding || error.y > 1.0f;
      });
      EXPECT_LE(missed, kind.name == std::string("panel of diamonds") ? pixels / 50 : 0) << kind.name << " " << share;
    }
  }
}

}  // namespace
}  // namespace lippmann
