#include "core/base64.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

// Test vectors of RFC 4648, section 10.
TEST(Base64, texts_of_every_length_match_the_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, bytes_above_127_are_unsigned) { EXPECT_EQ(base64("\xff\xfe\xfd"), "//79"); }

}  // namespace
}  // namespace lippmann
