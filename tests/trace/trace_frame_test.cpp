// Tests settings that must not change a picture: the number of threads, the order of rays, and the storage of
// instances.
#include "trace/trace_frame.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

SmallScene scene_with_all_rays() {
  SmallScene s = busy_scene(3);
  s.add(square(3, -2), 1);
  s.point_light({-3, 4, 8}, Vec3f(0.4f));
  return s;
}

TEST(TraceFrame, threads_do_not_change_bits) {
  const SmallScene s = scene_with_all_rays();
  const Picture one = trace(s.scene, lenticular_view(), {}, 1);
  for (const int threads : {2, 4}) {
    const Picture many = trace(s.scene, lenticular_view(), {}, threads);
    EXPECT_EQ(one.film.data, many.film.data);
    EXPECT_EQ(one.counts.total(), many.counts.total());
  }
}

TEST(TraceFrame, every_ray_order_gives_the_same_picture) {
  const SmallScene s = scene_with_all_rays();
  TraceParams params;
  params.order = RayOrder::kRows;
  const Picture rows = trace(s.scene, lenticular_view(), params);
  for (const RayOrder order : {RayOrder::kColumns, RayOrder::kViewTiles}) {
    params.order = order;
    EXPECT_EQ(rows.film.data, trace(s.scene, lenticular_view(), params).film.data) << static_cast<int>(order);
  }
}

TEST(TraceFrame, moving_objects_equal_static_ones) {
  const Vec3f there(0.3f, -0.2f, 0.5f);
  const auto build = [&](bool moving) {
    SmallScene s;
    s.scene.max_depth = 3;
    PhongSurface shiny = matte({0.8f, 0.4f, 0.2f});
    shiny.mirror = 0.3f;
    const int material = s.material(shiny);
    const int node = moving ? s.moving_node(there - Vec3f(1, 1, 1), there + Vec3f(1, 1, 1)) : s.node({Mat3f(1.0f), there});
    s.add(square(0.5f, 0.8f), material, node);
    s.add(Spheres{{{0.9f, 0, 0}, 0.4f}}, material, node);
    s.add(Cylinders{{{-0.9f, -0.5f, 0}, {-0.9f, 0.5f, 0.2f}, 0.3f}}, material, node);
    s.add(Rings{{{0, 0.9f, 0}, {0, 0, 1}, 0.1f, 0.4f}}, material, node);
    s.add(Boxes{{{-0.4f, -1.2f, -0.4f}, {0.4f, -0.8f, 0.4f}}}, material, node);
    s.add(Planes{{{0, 0, -3}, {0, 0, 1}}}, material, node);
    s.point_light({3, 4, 8});
    return s;
  };
  const Picture fixed = trace(build(false).scene, lenticular_view());
  const Picture moved = trace(build(true).scene, lenticular_view(), {}, 1, 0.5);
  double squares = 0;
  for (std::size_t i = 0; i < fixed.film.data.size(); ++i) {
    const double d = fixed.film.data[i] - moved.film.data[i];
    squares += d * d;
  }
  // Rounding of the transform may move an edge across the centres of a few of the 3,200 pixels.
  EXPECT_LT(squares / static_cast<double>(fixed.film.data.size()), 1e-4);
  EXPECT_NE(trace(build(true).scene, lenticular_view(), {}, 1, 0.0).film.data, moved.film.data);
}

TEST(TraceFrame, instanced_meshes_equal_flattened_ones) {
  // A mesh becomes an Embree instance if its copies have more than 200,000 triangles in total.
  const auto build = [&](int cuts) {
    SmallScene s;
    Mesh grid;
    for (int y = 0; y <= cuts; ++y)
      for (int x = 0; x <= cuts; ++x) grid.positions.push_back({x / float(cuts) - 0.5f, y / float(cuts) - 0.5f, 0});
    const auto row = static_cast<std::uint32_t>(cuts + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y)
      for (std::uint32_t x = 0; x + 1 < row; ++x) {
        grid.triangles.push_back({y * row + x, y * row + x + 1, (y + 1) * row + x});
        grid.triangles.push_back({y * row + x + 1, (y + 1) * row + x + 1, (y + 1) * row + x});
      }
    const int material = s.material(matte(Vec3f(1.0f)));
    const Mat3f tilt = 1.3f * glm::mat3_cast(glm::angleAxis(0.4f, Vec3f(1, 0, 0)));
    s.add(grid, material, s.node({tilt, {-1, 0, 0}}));
    s.scene.instances.push_back({"", 0, material, s.node({tilt, {1, 0, 0.5f}})});
    s.point_light({3, 4, 8});
    return s;
  };
  const Picture flattened = trace(build(4).scene, single_view(33)), shared = trace(build(320).scene, single_view(33));
  std::size_t different = 0;
  for (std::size_t i = 0; i < flattened.film.data.size(); ++i)
    different += std::abs(flattened.film.data[i] - shared.film.data[i]) > 1e-4f;
  EXPECT_LE(different, 6u) << "at most two edge pixels";
  EXPECT_GT(flattened.at(8, 16).x, 0.1f);
}

TEST(TraceFrame, samples_average_edges_by_coverage) {
  SmallScene s;
  Mesh half = square(10, 0);
  for (Vec3f& p : half.positions) p.x = p.x < 0 ? -10.0f : 0.0f;  // covers x < 0, half of the middle column
  s.add(half, s.material(glowing(Vec3f(1.0f))));
  TraceParams params;
  params.spp = 64;
  const Picture p = trace(s.scene, single_view(33), params);
  for (int y = 0; y < 33; ++y) EXPECT_NEAR(p.at(16, y).x, 0.5f, 1.01f / 64) << "stratified: at most one sample off";
  EXPECT_NEAR(p.at(10, 5).x, 1.0f, 1e-5f);
  EXPECT_EQ(p.at(20, 5).x, 0.0f);
  EXPECT_EQ(p.film.data, trace(s.scene, single_view(33), params).film.data) << "repeats bit for bit";
  params.seed = 1;
  EXPECT_NE(p.film.data, trace(scene_with_all_rays().scene, single_view(33), params).film.data);
}

TEST(TraceFrame, uneven_panel_is_filled_to_its_last_pixel) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(1.0f);
  Optics optics = single_view(33);
  optics.panel = {37, 19, 0.1f};
  for (const float v : trace(s.scene, optics).film.data) ASSERT_EQ(v, 1.0f);
}

TEST(TraceFrame, cancelled_before_it_starts_traces_nothing) {
  const SmallScene s = scene_with_all_rays();
  const ThreadPool pool(1);
  Context context;
  context.cancelled = true;
  DeviceScene device(s.scene, pool);
  Image film;
  EXPECT_EQ(trace_frame({device, lenticular_view(), Affine3f{}}, {}, {pool, context}, {film}).total(), 0u);
}

}  // namespace
}  // namespace lippmann
