#include "lippmann/core/version.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Version, text_and_number_are_made_of_the_macros) {
  EXPECT_EQ(version(), fmt::format("{}.{}.{}", LIPPMANN_VERSION_MAJOR, LIPPMANN_VERSION_MINOR, LIPPMANN_VERSION_PATCH));
  EXPECT_STREQ(version(), LIPPMANN_VERSION_STRING);
  EXPECT_EQ(fmt::format("{}.{}.{}", LIPPMANN_VERSION / 10000, LIPPMANN_VERSION / 100 % 100, LIPPMANN_VERSION % 100), version());
}

}  // namespace
}  // namespace lippmann
