#include "lippmann/core/error.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Error, what_has_all_parts) {
  const Error error("a.dat:12", "unknown keyword FOO", "SPHERE, PLANE");
  EXPECT_STREQ(error.what(), "a.dat:12: unknown keyword FOO; accepted: SPHERE, PLANE");
  EXPECT_EQ(error.exit_code(), 1);
}

TEST(Error, usage_error_exits_with_2) {
  EXPECT_EQ(usage_error("--lenses", "0 lenses").exit_code(), 2);
  EXPECT_STREQ(usage_error("--lenses", "0 lenses").what(), "--lenses: 0 lenses");
}

// Escape sequences in names from files must not reach the terminal.
TEST(Error, has_no_control_characters) {
  const Error error("a\x1b[2J.exr", "has no channel \x1b]0;x\x07", "R\nG");
  EXPECT_STREQ(error.what(), "a?[2J.exr: has no channel ?]0;x?; accepted: R?G");
  EXPECT_EQ(error.problem(), "has no channel ?]0;x?");
}

}  // namespace
}  // namespace lippmann
