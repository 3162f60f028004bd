// Rays of a table must be returned unchanged. Operations that need an inverse mapping or views must fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/models.hpp"
#include "optics/optics_json.hpp"
#include "optics/ray_generator.hpp"
#include "random_optics.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

constexpr Panel kPanel{6, 4, 0.5f};

Ray some_ray(Vec2f pixel) {
  return {{pixel.x, -pixel.y, 10.0f + pixel.x}, glm::normalize(Vec3f(0.1f * pixel.x, 0.05f * pixel.y, -1.0f))};
}

Optics table_of(int samples_per_side) { return {.panel = kPanel, .model = make_ray_table(kPanel, samples_per_side, some_ray)}; }

void expect_same_ray(const Ray& a, const Ray& b) {
  EXPECT_LE(glm::distance(a.origin, b.origin), 1e-5f);
  EXPECT_LE(glm::distance(a.direction, b.direction), 1e-6f);
}

TEST(RayTable, pixels_have_the_rays_that_were_given) {
  const Optics optics = table_of(1);
  validate(optics);
  for (int j = 0; j < kPanel.height; ++j)
    for (int i = 0; i < kPanel.width; ++i)
      expect_same_ray(ray_of_pixel(optics, Vec2f(i, j) + 0.5f), some_ray(Vec2f(i, j) + 0.5f));
}

TEST(RayTable, samples_use_the_ray_of_their_part) {
  const Optics optics = table_of(4);
  expect_same_ray(ray_of_pixel(optics, {2.3f, 1.9f}), some_ray({2.375f, 1.875f}));
  expect_same_ray(ray_of_pixel(optics, {6.0f, 4.0f}), some_ray({5.875f, 3.875f}));
}

TEST(RayTable, blocks_are_bit_identical_in_any_frame) {
  const Optics optics = table_of(2);
  const RayGenerator generator(optics, {Mat3f{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}, {1, 2, 3}});
  const Ray ray = generator.ray({2.6f, 1.1f});
  float px[16], py[16], out[6][16];
  std::fill_n(px, 16, 2.6f), std::fill_n(py, 16, 1.1f);
  generator.rays(px, py, 16, {out[0], out[1], out[2], out[3], out[4], out[5]});
  EXPECT_EQ(Vec3f(out[0][7], out[1][7], out[2][7]), ray.origin);
  EXPECT_EQ(Vec3f(out[3][7], out[4][7], out[5][7]), ray.direction);
  const Ray there = some_ray({2.75f, 1.25f});
  expect_same_ray(ray, {2.0f * Vec3f(-there.origin.y, there.origin.x, there.origin.z) + Vec3f(1, 2, 3),
                        {-there.direction.y, there.direction.x, there.direction.z}});
}

TEST(RayTable, starts_at_the_foremost_origin) {
  const Optics optics = table_of(1);
  EXPECT_EQ(resolved_z_front_mm(optics), 15.5f);
  EXPECT_EQ(window_size_mm(optics), Vec2f(3.0f, 2.0f));
  EXPECT_EQ(whole_pixels_per_lens(optics), Vec2i(0));
  EXPECT_FALSE(has_lenses(optics) || view_tiles(optics) || is_single_view(optics) || view_cameras(optics));
  EXPECT_EQ(depth_budget_mm(optics), kInfinity);
}

TEST(RayTable, what_needs_an_inverse_is_refused) {
  const Optics optics = table_of(1);
  std::vector<Vec2f> pixels;
  EXPECT_THAT(test::error_message([&] { pixels_seeing(optics, {0, 0, 0}, pixels); }), HasSubstr("table of rays"));
  EXPECT_THAT(test::error_message([&] { make_sight(optics); }), HasSubstr("table of rays"));
  EXPECT_THAT(test::error_message([&] { optics_from_json(optics_json(optics), "report.json"); }), HasSubstr("report.json"));
}

TEST(RayTable, bad_rays_are_refused) {
  RayTable table = make_ray_table(kPanel, 1, some_ray);
  const auto message = [&] { return test::error_message([&] { validate(Optics{.panel = kPanel, .model = table}); }); };
  std::vector<Ray> rays = *table.rays;
  const auto with = [&](std::size_t i, Ray ray) {
    std::vector<Ray> changed = rays;
    changed[i] = ray;
    table.rays = std::make_shared<const std::vector<Ray>>(std::move(changed));
  };
  with(3, {{0, 0, 0}, {0, 0, 1}});
  EXPECT_THAT(message(), HasSubstr("ray 3"));
  with(4, {{0, 0, std::nanf("")}, {0, 0, -1}});
  EXPECT_THAT(message(), HasSubstr("ray 4"));
  with(5, {{0, 0, 0}, {0, 0, -2}});
  EXPECT_THAT(message(), HasSubstr("ray 5"));
  rays.pop_back();
  table.rays = std::make_shared<const std::vector<Ray>>(rays);
  EXPECT_THAT(message(), HasSubstr("23 rays"));
  table.rays.reset();
  EXPECT_THAT(message(), HasSubstr("0 rays"));
}

}  // namespace
}  // namespace lippmann
