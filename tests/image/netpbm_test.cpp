#include "image/netpbm.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

std::vector<std::byte> bytes(const std::string& text) {
  const auto all = std::as_bytes(std::span(text));
  return {all.begin(), all.end()};
}

/// 2 x 2 grey pixels, the bottom row (3, 4) before the top row (1, 2), as little-endian floats.
const std::string kPfm(
    "Pf\n2 2\n-1\n"
    "\x00\x00\x40\x40\x00\x00\x80\x40"
    "\x00\x00\x80\x3f\x00\x00\x00\x40",
    26);

TEST(Pfm, bottom_row_is_first_and_little_endian) {
  Image image(2, 2, 1);
  image.data = {1.0f, 2.0f, 3.0f, 4.0f};
  EXPECT_EQ(encode_pfm(image), bytes(kPfm));
  EXPECT_EQ(parse_pfm(bytes(kPfm), "a").data, image.data);
}

TEST(Pfm, positive_scale_is_big_endian_and_multiplies) {
  const Image image = parse_pfm(bytes(std::string("Pf 1 1 2.0\n\x3f\x80\x00\x00", 15)), "a");
  EXPECT_EQ(image.data, std::vector<float>{2.0f});
}

TEST(Pfm, three_channels_infinities_and_nan_come_back) {
  Image image(1, 2, 3);
  image.data = {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), 1e-30f, -0.5f, 3e38f, NAN};
  const Image back = parse_pfm(encode_pfm(image), "a");
  ASSERT_EQ(back.channels, 3);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(back.data[i], image.data[i]);
  EXPECT_TRUE(std::isnan(back.data[5]));
}

TEST(Ppm, codes_above_255_have_two_bytes) {
  const PpmCodes ppm{{1, 1, {1, 256, 1023}}, 1023};
  EXPECT_EQ(encode_ppm(ppm), bytes(std::string("P6\n1 1\n1023\n\x00\x01\x01\x00\x03\xff", 18)));
  EXPECT_EQ(parse_ppm(encode_ppm(ppm), "a").codes.rgb, ppm.codes.rgb);
}

TEST(Ppm, eight_bits_comments_and_grey_are_read) {
  EXPECT_EQ(parse_ppm(bytes("P6 # made by\n1 # high\n1\n255\nabc"), "a").codes.rgb, (std::vector<std::uint16_t>{97, 98, 99}));
  EXPECT_EQ(parse_ppm(bytes("P5 2 1 255\nab"), "a").codes.rgb, (std::vector<std::uint16_t>{97, 97, 97, 98, 98, 98}));
}

TEST(Netpbm, wrong_headers_are_refused) {
  const auto ppm = [](const std::string& text) { return error_message([&] { parse_ppm(bytes(text), "a.ppm"); }); };
  const auto pfm = [](const std::string& text) { return error_message([&] { parse_pfm(bytes(text), "a.pfm"); }); };
  for (const char* text : {"", "P3 1 1 255 1 1 1", "PNG"}) EXPECT_THAT(ppm(text), HasSubstr("is not a PPM"));
  for (const char* text :
       {"P6", "P6\n# a comment without an end", "P6 a 1 255\n", "P6 99999999999 1 255\n", "P6 1 1.5 255\nabc"})
    EXPECT_THAT(ppm(text), HasSubstr("its header has no"));
  for (const char* text : {"P6 0 1 255\n", "P6 -1 1 255\n", "P6 65537 1 255\n", "P6 65536 65536 255\n"})
    EXPECT_THAT(ppm(text), HasSubstr("a picture of"));
  EXPECT_THAT(ppm("P6 1 1 70000\nabc"), HasSubstr("highest code is 70000"));
  EXPECT_THAT(ppm("P6 1 1 100\nabz"), HasSubstr("above the maximum of 100"));
  EXPECT_THAT(ppm("P6 16384 16384 255\nabc"), HasSubstr("truncated"));
  EXPECT_THAT(ppm("P6 1 1 255"), HasSubstr("truncated"));
  EXPECT_THAT(pfm("Pf 1 1 0\nabcd"), HasSubstr("its scale is 0"));
  EXPECT_THAT(pfm("Pf 1 1 nan\nabcd"), HasSubstr("its scale is"));
  EXPECT_THAT(pfm("Pf -4 1 -1\nabcd"), HasSubstr("a picture of"));
  EXPECT_THAT(pfm("Pf 16384 16384 -1\nabcd"), HasSubstr("truncated"));
}

}  // namespace
}  // namespace lippmann
