#include "view/near_edges.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;

Image row_of(std::vector<float> values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  image.data = std::move(values);
  return image;
}

TEST(NearEdges, pixel_beside_something_near_moves_with_it) {
  Image row = row_of({-500, -500, -500, 10, 11, -500});
  spread_near_disparities(row, {6, 1}, 5.0);
  EXPECT_THAT(row.data, ElementsAre(-500, -500, 10, 10, 11, 11));
}

TEST(NearEdges, background_moves_with_near_neighbours) {
  Image row = row_of({-kInfinity, -kInfinity, 10, kInfinity, -kInfinity});
  spread_near_disparities(row, {5, 1}, 5.0);
  EXPECT_THAT(row.data, ElementsAre(-kInfinity, 10, 10, kInfinity, -kInfinity));
}

TEST(NearEdges, surfaces_that_recede_keep_their_disparities) {
  Image row = row_of({0, 4, 8, 12, 8, 4});
  spread_near_disparities(row, {6, 1}, 5.0);
  EXPECT_THAT(row.data, ElementsAre(0, 4, 8, 12, 8, 4));
}

TEST(NearEdges, neighbours_lie_in_the_same_view) {
  Image tiles = row_of({-500, -500, 10, -500});
  spread_near_disparities(tiles, {2, 1}, 5.0);
  EXPECT_THAT(tiles.data, ElementsAre(-500, -500, 10, 10));
  Image corners(4, 4, 1);  // four views of 2 x 2 pixels
  corners.data.assign(16, -500);
  *corners.pixel(2, 2) = 10;
  spread_near_disparities(corners, {2, 2}, 5.0);
  EXPECT_THAT(corners.data,
              ElementsAre(-500, -500, -500, -500, -500, -500, -500, -500, -500, -500, 10, 10, -500, -500, 10, 10));
}

// Neighbouring views are 0.1 apart in slope, so a disparity difference of 10 mm is a shift of 1 mm, half of a pixel of 2 mm.
TEST(NearEdges, half_a_pixel_is_a_visible_jump) {
  PageFacts facts;
  facts.window.size = {200.0, 100.0};
  facts.axes.across = {.count = 4, .first = -0.15, .step = 0.1};
  EXPECT_NEAR(visible_jump_mm(facts, {100, 50}), 10.0, 1e-9);
  facts.axes.up = {.count = 2, .first = -0.1, .step = 0.2};
  EXPECT_NEAR(visible_jump_mm(facts, {100, 50}), 5.0, 1e-9);
  facts.axes = {};
  EXPECT_TRUE(std::isinf(visible_jump_mm(facts, {100, 50})));
}

}  // namespace
}  // namespace lippmann
