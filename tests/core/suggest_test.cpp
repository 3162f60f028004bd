#include "core/suggest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lippmann {
namespace {

TEST(EditDistance, known_pairs_match_values_by_hand) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("abc", ""), 3);
  EXPECT_EQ(edit_distance("lenses", "lenses"), 0);
  EXPECT_EQ(edit_distance("lense", "lenses"), 1);
}

TEST(EditDistance, exchanged_neighbours_count_once) {
  EXPECT_EQ(edit_distance("pgn", "png"), 1);
  EXPECT_EQ(edit_distance("dpeth", "depth"), 1);
  EXPECT_EQ(edit_distance("ca", "abc"), 3) << "no letter is edited twice";
}

TEST(NearestName, misspelt_name_finds_the_closest_candidate) {
  constexpr std::array<std::string_view, 3> kNames{"lenses", "lens-pixels", "size"};
  EXPECT_EQ(nearest_name("lense", kNames), "lenses");
  EXPECT_EQ(nearest_name("lens_pixels", kNames), "lens-pixels");
}

TEST(NearestName, short_name_with_exchanged_letters_is_found) {
  constexpr std::array<std::string_view, 4> kNames{"png", "png16", "tiff", "exr"};
  EXPECT_EQ(nearest_name("pgn", kNames), "png");
  EXPECT_EQ(did_you_mean("pgn", kNames), ", did you mean 'png'?");
  EXPECT_EQ(did_you_mean("webp!", kNames), "");
}

TEST(NearestName, unrelated_name_finds_nothing) {
  constexpr std::array<std::string_view, 2> kNames{"lenses", "size"};
  EXPECT_EQ(nearest_name("quux", kNames), "");
}

TEST(NearestName, name_containing_the_word_is_suggested) {
  constexpr std::string_view kNames[] = {"lenticular-40lpi-600dpi", "lenticular-60lpi-600dpi", "lenticular-60lpi-720dpi"};
  EXPECT_EQ(nearest_name("60lpi", kNames), "lenticular-60lpi-600dpi");
  EXPECT_EQ(nearest_name("60-lpi", kNames), "lenticular-60lpi-600dpi");
  EXPECT_EQ(nearest_name("le", kNames), "") << "two letters occur in too many names";
}

}  // namespace
}  // namespace lippmann
