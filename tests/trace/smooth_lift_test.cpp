#include "shading/smooth_lift.hpp"

#include "trace/coarse_ball.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

// The corners are the ends of a quarter of the unit circle, with normals away from its centre. The point half-way
// between them lies 1/2 below the tangent plane of each corner. Each plane lifts the point along its normal by half of
// this distance, so the lift is 1/4 along x and 1/4 along y.
TEST(SmoothLift, half_way_along_chords_matches_by_hand) {
  const SmoothTriangle chord{{{{1, 0, 0}, {0, 1, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {0, 3, 0}, {0, 1, 0}}}, {0.5f, 0.5f, 0.0f}};
  expect_color(smooth_lift(chord, 1.0f), {0.25f, 0.25f, 0.0f});
  EXPECT_EQ(smooth_lift(chord, -1.0f), Vec3f(0.0f));  // on the inner side, the smooth surface is below the chord
}

TEST(SmoothLift, corners_and_flat_triangles_are_not_lifted) {
  const SmoothTriangle flat{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}, {0.2f, 0.3f, 0.5f}};
  EXPECT_EQ(smooth_lift(flat, 1.0f), Vec3f(0.0f));
  SmoothTriangle bent = flat;
  bent.normals[1] = {1, 0, 1}, bent.weights = {1.0f, 0.0f, 0.0f};
  EXPECT_EQ(smooth_lift(bent, 1.0f), Vec3f(0.0f));
}

template <class Shape>
SmallScene lit_ball(const Shape& ball) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(ball, s.material(matte(Vec3f(0.8f))));
  s.point_light({30, 4, 6}, Vec3f(1500.0f));
  return s;
}

float largest_difference(const Image& a, const Image& b) {
  float most = 0.0f;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const float from_middle = std::hypot(static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(a.width),
                                           static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(a.height));
      if (from_middle < 0.3f * static_cast<float>(a.width))
        most = std::max(most, std::abs(a.pixel(x, y)[0] - b.pixel(x, y)[0]));
    }
  return most;
}

// Without smooth_lift(), single facets near the terminator would be dark.
TEST(SmoothLift, coarse_balls_are_lit_like_balls) {
  const SmallScene round = lit_ball(Spheres{{{{0, 0, 0}, 1.5f}}}), coarse = lit_ball(coarse_ball(1.5f, 8));
  const Optics view = single_view(48);
  const float brightest = [&] {
    const Image film = trace(round.scene, view).film;
    return *std::max_element(film.data.begin(), film.data.end());
  }();
  EXPECT_LT(largest_difference(trace(round.scene, view).film, trace(coarse.scene, view).film), 0.06f * brightest);
  EXPECT_LT(largest_difference(trace_paths(round.scene, view, 16).film, trace_paths(coarse.scene, view, 16).film),
            0.06f * brightest);
}

TEST(SmoothLift, occluders_still_cast_shadows) {
  SmallScene s = lit_ball(coarse_ball(1.5f, 8));
  s.add(Boxes{{{3.0f, -4.0f, -4.0f}, {3.2f, 4.0f, 4.0f}}}, s.material(matte(Vec3f(0.0f))));
  const Image film = trace(s.scene, single_view(32)).film;
  EXPECT_EQ(*std::max_element(film.data.begin(), film.data.end()), 0.0f);
}

}  // namespace
}  // namespace lippmann
