#include "core/suggest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lippmann {
namespace {

TEST(EditDistance, known_pairs_give_the_distances_worked_out_by_hand) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("abc", ""), 3);
  EXPECT_EQ(edit_distance("lenses", "lenses"), 0);
  EXPECT_EQ(edit_distance("lense", "lenses"), 1);
}

TEST(NearestName, misspelt_name_finds_the_closest_candidate) {
  constexpr std::array<std::string_view, 3> kNames{"lenses", "lens-pixels", "size"};
  EXPECT_EQ(nearest_name("lense", kNames), "lenses");
  EXPECT_EQ(nearest_name("lens_pixels", kNames), "lens-pixels");
}

TEST(NearestName, unrelated_name_finds_nothing) {
  constexpr std::array<std::string_view, 2> kNames{"lenses", "size"};
  EXPECT_EQ(nearest_name("quux", kNames), "");
}

}  // namespace
}  // namespace lippmann
