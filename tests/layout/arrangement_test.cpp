#include "lippmann/layout/arrangement.hpp"

#include <gmock/gmock.h>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;

Image counting(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i);
  return image;
}

TEST(Arrangement, rearranges_lenses_into_quilt_tiles) {
  // Two lenses have 2 x 1 pixels each, 0 1 and 2 3. The left eye sees the right pixel of each lens, 1 and 3.
  const Arrangement arrangement({LayoutKind::kIntegral, {2, 1}, {}}, {LayoutKind::kQuilt, {2, 1}, {2, 1}}, {4, 1}, "p");
  EXPECT_THAT(arrangement.apply(counting(4, 1, 1)).data, ElementsAre(1, 3, 0, 2));
}

TEST(Arrangement, stacks_quilt_views_with_all_channels) {
  // Two tiles of one pixel, one above the other. The lower tile is view 0.
  const Arrangement arrangement({LayoutKind::kQuilt, {2, 1}, {1, 2}}, {LayoutKind::kStack, {2, 1}, {}}, {1, 2}, "p");
  EXPECT_EQ(arrangement.target_size(), Vec2i(1, 2));
  EXPECT_THAT(arrangement.apply(counting(1, 2, 2)).data, ElementsAre(2, 3, 0, 1));
}

TEST(Arrangement, there_and_back_is_the_same_picture) {
  const ViewLayout integral{LayoutKind::kIntegral, {3, 2}, {}}, quilt{LayoutKind::kQuilt, {3, 2}, {2, 3}};
  const Arrangement there(integral, quilt, {12, 10}, "p"), back(quilt, integral, there.target_size(), "p");
  const Image image = counting(12, 10, 3);
  EXPECT_EQ(back.apply(there.apply(image)).data, image.data);
}

TEST(Arrangement, rejects_views_that_do_not_fill) {
  EXPECT_THROW(Arrangement({LayoutKind::kIntegral, {3, 1}, {}}, {LayoutKind::kStack, {3, 1}, {}}, {8, 8}, "p"), Error);
}

}  // namespace
}  // namespace lippmann
