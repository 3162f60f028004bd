#include <gtest/gtest.h>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

TEST(TracedFrames, threads_and_ray_order_do_not_change_bits) {
  const auto expected = make_frames(small_scene(), frames_from(0, 2), 1).films();
  for (const int threads : {2, 4}) EXPECT_EQ(make_frames(small_scene(), frames_from(0, 2), threads).films(), expected);
  for (const RayOrder order : {RayOrder::kRows, RayOrder::kColumns}) {
    RenderParams params = small_scene();
    params.sampling.order = order;
    EXPECT_EQ(make_frames(params, frames_from(0, 2)).films(), expected);
  }
}

TEST(TracedFrames, several_samples_do_not_depend_on_threads) {
  RenderParams params = small_scene();
  params.sampling.spp = 4;
  EXPECT_EQ(make_frames(params, {5}, 1).films(), make_frames(params, {5}, 4).films());
}

TEST(TracedFrames, have_the_size_of_their_optics) {
  const std::vector<std::pair<OpticsParams, Vec2i>> kinds{
      {{.lens_pixels = {13.776f, 0}, .size = {90, 50}, .slant_deg = -9.46f}, {90, 50}},
      {{.kind = OpticsKind::kMicrolens, .lenses = {10, 6}, .lens_pixels = {5, 0}}, {50, 30}},
      {{.kind = OpticsKind::kMicrolens,
        .packing = LensPacking::kHexagonal,
        .lenses = {10, 0},
        .viewing_distance_mm = kInfinity},
       {80, 69}},
      {{.kind = OpticsKind::kMultiview, .size = {60, 40}, .views = {3, 2}}, {60, 40}},
      {{.kind = OpticsKind::kSingle, .size = {33, 21}}, {33, 21}}};
  for (const auto& [optics, size] : kinds) {
    RenderParams params = small_scene();
    params.optics = optics;
    const Image film = make_frames(params, {0}).frames.at(0).pictures.film;
    EXPECT_EQ(Vec2i(film.width, film.height), size);
  }
}

}  // namespace
}  // namespace lippmann::test
