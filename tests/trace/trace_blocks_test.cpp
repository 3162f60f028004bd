// A block traced alone equals the same block of the whole frame. Each block records which boxes its rays hit.
#include <gtest/gtest.h>

#include "lippmann/optics/optics.hpp"
#include "trace/small_scene.hpp"
#include "trace/strip_order.hpp"
#include "trace/trace_packets.hpp"

namespace lippmann {
namespace {

using namespace test;

struct TracedBlocks {
  Image film;
  TouchedBlocks touched;
};

class TraceBlocks : public testing::TestWithParam<RayOrder> {
 protected:
  TraceBlocks() : device_(scene_, pool_) {
    device_.update(evaluate(scene_, 0.4), pool_);
    params_.order = GetParam();
    params_.max_depth = scene_.max_depth;
    params_.spp = 2;
  }

  TracedBlocks frame(const std::vector<HorizonBox>& boxes) {
    TracedBlocks traced;
    traced.touched.boxes = boxes;
    trace_frame({device_, optics_, {}}, params_, {pool_, context_}, {traced.film, nullptr, nullptr, &traced.touched});
    return traced;
  }

  Scene scene_ = busy_scene(11).scene;
  Optics optics_ = single_view(70);
  ThreadPool pool_{2};
  Context context_;
  DeviceScene device_;
  TraceParams params_;
};

TEST_P(TraceBlocks, blocks_traced_alone_equal_the_frame) {
  const TracedBlocks whole = frame({});
  const std::size_t blocks = whole.touched.lowest_horizon.size();
  ASSERT_GT(blocks, 10u);
  for (const std::size_t every : {2u, 3u}) {
    Image film = whole.film;
    std::fill(film.data.begin(), film.data.end(), -1.0f);
    std::vector<std::uint8_t> wanted(blocks, 0);
    for (std::size_t b = 0; b < blocks; b += every) wanted[b] = 1;
    const RayCounts counts = trace_blocks({device_, optics_, {}}, params_, wanted, {pool_, context_}, film);
    std::size_t traced = 0;
    for (std::size_t i = 0; i < film.data.size(); ++i) {
      if (film.data[i] == -1.0f) continue;
      ++traced;
      ASSERT_EQ(film.data[i], whole.film.data[i]);
    }
    EXPECT_EQ(2 * traced, 3 * counts.primary) << "two samples each, three channels";
    EXPECT_GT(traced, 0u);
    EXPECT_LT(traced, film.data.size());
  }
}

TEST_P(TraceBlocks, rays_of_blocks_sum_to_the_frame) {
  const TracedBlocks whole = frame({});
  std::uint64_t rays = 0;
  for (const std::uint32_t n : whole.touched.rays) rays += n;
  Image film;
  EXPECT_EQ(rays, trace_frame({device_, optics_, {}}, params_, {pool_, context_}, {film}).total());
  EXPECT_EQ(film.data, whole.film.data);
}

TEST_P(TraceBlocks, surrounding_boxes_are_hit_distant_ones_missed) {
  const Bounds3f around{Vec3f(-50), Vec3f(50)}, away{Vec3f(500), Vec3f(501)}, endless{Vec3f(-kInfinity), Vec3f(kInfinity)};
  const auto expect_all = [&](const std::vector<HorizonBox>& boxes, std::uint8_t expected) {
    const TouchedBlocks touched = frame(boxes).touched;
    for (std::size_t b = 0; b < touched.rays.size(); ++b)
      if (touched.rays[b] > 0) {  // the last strip has blocks without pixels
        EXPECT_EQ(touched.lowest_horizon[b], expected) << "block " << b;
      }
  };
  expect_all({{away, 0}, {around, 3}}, 3);
  expect_all({{away, 0}}, TouchedBlocks::kNever);
  expect_all({{around, 5}, {endless, 2}}, 2);
}

TEST_P(TraceBlocks, packets_traced_alone_equal_the_frame) {
  const TracedBlocks whole = frame({});
  const StripOrder order = make_strip_order(optics_, GetParam());
  const std::size_t per_strip = (order.pixels.size() + 15) / 16;
  const auto strips = static_cast<std::size_t>((70 + order.strip_height - 1) / order.strip_height);
  std::vector<std::uint8_t> wanted(per_strip * strips, 0);
  for (std::size_t p = 0; p < wanted.size(); p += 3) wanted[p] = 1;
  Image film = whole.film;
  std::fill(film.data.begin(), film.data.end(), -1.0f);
  trace_packets({device_, optics_, {}}, params_, wanted, {pool_, context_}, film);
  for (std::size_t strip = 0; strip < strips; ++strip)
    for (std::size_t i = 0; i < order.pixels.size(); ++i) {
      const std::size_t y = strip * static_cast<std::size_t>(order.strip_height) + order.pixels[i].y;
      if (y >= 70) continue;
      const std::size_t at = 3 * (y * 70 + order.pixels[i].x);
      const bool is_wanted = wanted[strip * per_strip + i / 16] != 0;
      for (std::size_t c = at; c < at + 3; ++c) ASSERT_EQ(film.data[c], is_wanted ? whole.film.data[c] : -1.0f);
    }
}

TEST(TracePackets, of_paths_equal_the_frame) {
  SmallScene s;
  s.scene.max_depth = 4;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  s.add(Spheres{{{0.0f, 0.0f, 0.0f}, 1.0f}}, s.material(matte(Vec3f(0.6f))));
  s.add(square(3, -1), s.material(mirror(0.5f)));
  TraceParams params;
  params.max_depth = 4, params.spp = 4;
  const Picture whole = trace_paths(s.scene, single_view(64), 4, params);
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(s.scene, pool, Integrator::kPath);
  device.update(evaluate(s.scene, 0.0), pool);
  std::vector<std::uint8_t> wanted(64 * 64 / 16, 0);
  for (std::size_t p = 0; p < wanted.size(); p += 3) wanted[p] = 1;
  Image film(64, 64, 3);
  std::fill(film.data.begin(), film.data.end(), -1.0f);
  trace_packets({device, single_view(64), {}}, params, wanted, {pool, context}, film);
  std::size_t traced = 0;
  for (std::size_t i = 0; i < film.data.size(); ++i) {
    if (film.data[i] < 0.0f) continue;
    ++traced;
    EXPECT_NEAR(film.data[i], whole.film.data[i], 1e-5f) << i;
  }
  EXPECT_EQ(traced, 3 * 16 * ((wanted.size() + 2) / 3));
}

INSTANTIATE_TEST_SUITE_P(Orders, TraceBlocks, testing::Values(RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles),
                         [](const auto& order) {
                           return std::string(order.param == RayOrder::kViewTiles ? "view_tiles" : to_string(order.param));
                         });

/// Returns for each block of 4 rows of a 64 x 64 view: 1 if a ray hits the box, otherwise kNever.
std::vector<std::uint8_t> blocks_that_meet(SmallScene& s, const Bounds3f& box) {
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(s.scene, pool);
  device.update(evaluate(s.scene, 0.0), pool);
  TraceParams params;
  params.order = RayOrder::kRows;
  params.max_depth = s.scene.max_depth;
  TouchedBlocks touched;
  touched.boxes = {{box, 1}};
  Image film;
  trace_frame({device, single_view(64), {}}, params, {pool, context}, {film, nullptr, nullptr, &touched});
  return touched.lowest_horizon;
}

/// Expects that only rays of the given blocks hit the box. With RayOrder::kRows, block b of 64 x 4 pixels shows y from
/// 2 - (b + 1) / 4 to 2 - b / 4 in the plane z = 0.
void expect_met(const std::vector<std::uint8_t>& lowest_horizon, const std::set<std::size_t>& expected) {
  ASSERT_EQ(lowest_horizon.size(), 16u);
  for (std::size_t b = 0; b < 16; ++b)
    EXPECT_EQ(lowest_horizon[b], expected.contains(b) ? 1 : TouchedBlocks::kNever) << "block " << b;
}

TEST(TouchProbe, primary_rays_touch_boxes_before_their_hit) {
  SmallScene s;
  s.add(square(3, 0), s.material(glowing(Vec3f(1.0f))));
  expect_met(blocks_that_meet(s, {{0.1f, 0.3f, 0.0f}, {0.2f, 0.45f, 0.01f}}), {6});
  expect_met(blocks_that_meet(s, {{0.1f, 0.3f, -0.3f}, {0.2f, 0.45f, -0.2f}}), {});
}

TEST(TouchProbe, shadow_rays_touch_boxes_before_the_light) {
  SmallScene s;
  s.add(square(3, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 40, 4});
  // Shadow rays to the light at y = 40 pass the first box, from y = 20 to 24, where no view rays are.
  expect_met(blocks_that_meet(s, {{-50, 20, 1}, {50, 24, 3}}), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
  expect_met(blocks_that_meet(s, {{-50, 41, 1}, {50, 44, 3}}), {});
}

TEST(TouchProbe, mirror_rays_touch_reflected_boxes) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(3, 0), s.material(mirror(0.5f)));
  s.add(square(3, 30), s.material(glowing(Vec3f(1.0f))));
  // A mirror ray seems to start at the eye's mirror image at z = -10. A ray through the height y at z = 0 is at 3 y at
  // z = 20, three times as far from the mirror image.
  expect_met(blocks_that_meet(s, {{-9, 3 * 0.3f, 19.99f}, {9, 3 * 0.45f, 20.0f}}), {6});
}

}  // namespace
}  // namespace lippmann
