// What is tried until a history of cached light may begin.
#include "trace/light_beginnings.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(LightBeginnings, what_is_good_enough_ends_the_search) {
  Beginnings beginnings(true, true);
  EXPECT_EQ(beginnings.current().rounds, 4);
  EXPECT_FALSE(beginnings.go_on({true, 0.5f, 0.1f}));
  ASSERT_TRUE(beginnings.good());
  EXPECT_EQ(beginnings.good()->rounds, 4);
}

TEST(LightBeginnings, cells_that_make_most_of_the_error_are_fed_more_though_frames_are_good) {
  Beginnings beginnings(true, true);
  EXPECT_TRUE(beginnings.go_on({true, 0.9f, 0.6f}));
  EXPECT_EQ(beginnings.current().rounds, 8);
  EXPECT_FALSE(beginnings.go_on({true, 0.8f, 0.6f}));
  EXPECT_EQ(beginnings.good()->rounds, 8);
}

TEST(LightBeginnings, feeding_goes_on_as_long_as_it_helps) {
  Beginnings beginnings(false, false);
  float excess = 100.0f;
  int rounds = 4;
  for (; beginnings.current().rounds < 64; excess *= 0.5f) {
    EXPECT_EQ(beginnings.current().rounds, rounds);
    ASSERT_TRUE(beginnings.go_on({false, excess, 1.0f}));
    rounds *= 2;
  }
  EXPECT_EQ(beginnings.current().cell, 1.0f);
}

TEST(LightBeginnings, lamps_are_asked_where_feeding_does_not_help_and_cells_shrink_where_that_does_not) {
  Beginnings beginnings(true, true);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(beginnings.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(beginnings.current().rounds, 16);
  ASSERT_TRUE(beginnings.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(beginnings.current().lights_from, LightGroup::kSky);
  EXPECT_EQ(beginnings.current().cell, 1.0f);
  ASSERT_TRUE(beginnings.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(beginnings.current().lights_from, LightGroup::kLamps);
  EXPECT_EQ(beginnings.current().cell, 0.5f);
  EXPECT_FALSE(beginnings.good());
}

TEST(LightBeginnings, the_sky_is_asked_where_there_are_no_lamps) {
  Beginnings beginnings(false, true);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(beginnings.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(beginnings.current().lights_from, LightGroup::kEnd);
}

TEST(LightBeginnings, come_to_an_end_when_nothing_helps) {
  Beginnings beginnings(true, true);
  int tried = 1;
  while (beginnings.go_on({false, 4.0f, 1.0f})) ASSERT_LT(++tried, 10);
  EXPECT_FALSE(beginnings.good());
}

}  // namespace
}  // namespace lippmann
