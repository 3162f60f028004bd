#include "job/size_estimate.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(BytesText, has_two_significant_digits) {
  EXPECT_EQ(bytes_text(0.0), "0.00 MB");
  EXPECT_EQ(bytes_text(351'000.0), "0.35 MB");
  EXPECT_EQ(bytes_text(4'160'000.0), "4.2 MB");
  EXPECT_EQ(bytes_text(123'400'000.0), "123 MB");
  EXPECT_EQ(bytes_text(4.04e9), "4.0 GB");
}

}  // namespace
}  // namespace lippmann
