#include "view/preview.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

PageFacts quilt_of_views(Vec2i view_size) {
  PageFacts facts;
  facts.tiles = {2, 1}, facts.view_size = view_size;
  return facts;
}

TEST(Preview, small_quilt_has_no_preview) {
  EXPECT_FALSE(preview_view_size(quilt_of_views({512, 1023})));
  EXPECT_TRUE(preview_view_size(quilt_of_views({512, 1024})));
}

TEST(Preview, pixels_are_means_within_their_view) {
  const PageFacts facts = quilt_of_views({1024, 512});
  Image8 quilt{2048, 512, std::vector<unsigned char>(std::size_t{3} * 2048 * 512, 10)};
  for (std::size_t y = 0; y < 512; ++y)
    for (std::size_t x = 1024; x < 2048; ++x) quilt.rgb[3 * (y * 2048 + x)] = x % 2 == 0 ? 100 : 200;
  const Image8 small = preview_of(quilt, facts);
  ASSERT_EQ(Vec2i(small.width, small.height), Vec2i(1024, 256));
  EXPECT_EQ(small.rgb[std::size_t{3} * 511], 10);
  EXPECT_EQ(small.rgb[std::size_t{3} * 512], 150);
}

}  // namespace
}  // namespace lippmann
