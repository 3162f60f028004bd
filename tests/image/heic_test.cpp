// heif-enc and ffmpeg encoded tests/image/pictures. Each picture has four quarters of one colour each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/regular_file.hpp"
#include "image/decode.hpp"
#include "image/read_image.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using testing::HasSubstr;

constexpr int kWidth = 64, kHeight = 48;
constexpr std::array<std::array<int, 3>, 4> kQuarters{{{200, 60, 40}, {40, 180, 70}, {50, 70, 190}, {230, 230, 230}}};

fs::path picture(const char* name) { return fs::path(LIPPMANN_SOURCE) / "tests/image/pictures" / name; }

/// `code` is the step from one 8-bit code to the next: 1 in 8-bit images, 257 in 16-bit images.
template <class AnyImage>
void expect_quarters(const AnyImage& image, double code, double tolerance) {
  ASSERT_EQ(image.width, kWidth);
  ASSERT_EQ(image.height, kHeight);
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t x = kWidth / 4 + quarter % 2 * kWidth / 2, y = kHeight / 4 + quarter / 2 * kHeight / 2;
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(image.rgb[3 * (y * kWidth + x) + c] / code, kQuarters[quarter][c], tolerance) << quarter << " " << c;
  }
}

TEST(Heic, pictures_of_8_bits) {
  expect_quarters(std::get<Image8>(read_picture(picture("quarters.heic"))), 1.0, 2.0);
  expect_quarters(std::get<Image8>(read_picture(picture("quarters.avif"))), 1.0, 3.0);
}

TEST(Heic, pictures_of_10_bits_become_16) {
  expect_quarters(std::get<Image16>(read_picture(picture("quarters_10bit.heic"))), 257.0, 1.0);
}

// The depth map is a grey picture of half the size, marked by an auxl reference and the auxC property
// urn:mpeg:hevc:2015:auxid:2.
TEST(Heic, depth_image_beside_the_picture) {
  expect_quarters(std::get<Image8>(read_picture(picture("quarters_depth.heic"))), 1.0, 2.0);
  const std::optional<StoredDepth> depth = read_stored_depth(picture("quarters_depth.heic"));
  ASSERT_TRUE(depth);
  EXPECT_FALSE(depth->is_z);
  ASSERT_EQ(depth->grey.width, kWidth / 2);
  ASSERT_EQ(depth->grey.height, kHeight / 2);
  constexpr std::array<float, 4> kGreys{40, 120, 200, 240};
  for (int quarter = 0; quarter < 4; ++quarter)
    EXPECT_NEAR(depth->grey.pixel(8 + quarter % 2 * 16, 6 + quarter / 2 * 12)[0], kGreys[quarter] / 255.0f, 2.0f / 255.0f);
  EXPECT_FALSE(read_stored_depth(picture("quarters.heic")));
}

TEST(Heic, damage_is_an_error) {
  const std::vector<std::byte> whole = read_file_bytes(picture("quarters.heic"), 1 << 20, "a picture");
  for (std::size_t size = 12; size < whole.size(); size += 7)
    EXPECT_THAT(error_message([&] { decode_picture(std::span(whole).first(size), "cut.heic"); }), HasSubstr("cut.heic"))
        << size;
  std::vector<std::byte> large = whole;
  const std::string ispe = "ispe";
  const auto at = std::search(large.begin(), large.end(), ispe.begin(), ispe.end(),
                              [](std::byte a, char b) { return a == static_cast<std::byte>(b); });
  ASSERT_NE(at, large.end());
  at[8] = std::byte{0x7f};
  EXPECT_THAT(error_message([&] { decode_picture(large, "large.heic"); }), HasSubstr("large.heic"));
}

}  // namespace
}  // namespace lippmann
