#include "image/spare_images.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(SpareImages, kept_image_is_taken_once) {
  SpareImages spare;
  Image image(4, 2, 3);
  const float* memory = image.data.data();
  spare.give(std::move(image));
  EXPECT_EQ(spare.take().data.data(), memory);
  EXPECT_TRUE(spare.take().data.empty());
}

TEST(SpareImages, surplus_images_are_dropped) {
  SpareImages spare;
  for (int i = 0; i < 10; ++i) spare.give(Image(1, 1, 1));
  int kept = 0;
  while (!spare.take().data.empty()) ++kept;
  EXPECT_GE(kept, 1);
  EXPECT_LT(kept, 10);
}

}  // namespace
}  // namespace lippmann
