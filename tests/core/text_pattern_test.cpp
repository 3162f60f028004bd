#include <gmock/gmock.h>

#include "core/text_pattern.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;

TEST(TextPattern, match_is_of_the_whole_text) {
  const TextPattern pattern("view_([0-9]+)");
  EXPECT_FALSE(pattern.match("view_12.png"));
  EXPECT_FALSE(pattern.match("a view_12"));
  const auto found = pattern.match("view_12");
  ASSERT_TRUE(found);
  EXPECT_THAT(found->groups, ElementsAre("view_12", "12"));
}

TEST(TextPattern, search_finds_the_first_place) {
  const auto found = TextPattern("[0-9]+").search("a12b345");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->begin, 1u);
  EXPECT_EQ(found->end, 3u);
  EXPECT_THAT(found->groups, ElementsAre("12"));
  EXPECT_FALSE(TextPattern("[0-9]+").search("ab"));
}

TEST(TextPattern, unused_group_is_empty) {
  const auto found = TextPattern("([0-9]+)(?:-([0-9]+))?").match("7");
  ASSERT_TRUE(found);
  EXPECT_THAT(found->groups, ElementsAre("7", "7", ""));
}

TEST(TextPattern, case_can_be_ignored) {
  EXPECT_FALSE(TextPattern(".*\\.png").match("A.PNG"));
  EXPECT_TRUE(TextPattern(".*\\.png", TextPattern::Letters::kEitherCase).match("A.PNG"));
}

}  // namespace
}  // namespace lippmann
