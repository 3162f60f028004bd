#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/image_compare.hpp"
#include "support/pictures.hpp"

namespace lippmann {
namespace {

using test::images_match;
using test::noise_codes;

TEST(ImagesMatch, each_threshold_decides) {
  const Image8 reference = noise_codes(10, 10);
  Image8 image = reference;
  image.rgb[33] = static_cast<unsigned char>(reference.rgb[33] ^ 0x10);
  EXPECT_TRUE(images_match(reference, reference));
  EXPECT_TRUE(images_match(image, reference, {.per_pixel = 16}));
  EXPECT_TRUE(images_match(image, reference, {.per_pixel = 1, .share = 0.01, .hard_limit = 16}));
  EXPECT_FALSE(images_match(image, reference, {.per_pixel = 15}));
  EXPECT_FALSE(images_match(image, reference, {.per_pixel = 1, .share = 0.009, .hard_limit = 16}));
  EXPECT_FALSE(images_match(image, reference, {.per_pixel = 1, .share = 0.01, .hard_limit = 15}));
  std::filesystem::remove_all(test::detail::evidence_folder());
}

TEST(ImagesMatch, failure_names_the_pixel_and_writes_pictures) {
  const Image8 reference = noise_codes(10, 10);
  Image8 image = reference;
  image.rgb[33] = static_cast<unsigned char>(reference.rgb[33] ^ 0x10);
  const testing::AssertionResult result = images_match(image, reference);
  EXPECT_THAT(result.message(), ::testing::HasSubstr("(1, 1), by 16"));
  const auto folder = test::detail::evidence_folder();
  for (const char* name : {"image.png", "reference.png", "difference.png"}) EXPECT_TRUE(std::filesystem::exists(folder / name));
  std::filesystem::remove_all(folder);
}

TEST(ImagesMatch, different_sizes_never_match) { EXPECT_FALSE(images_match(noise_codes(4, 3), noise_codes(3, 4))); }

}  // namespace
}  // namespace lippmann
