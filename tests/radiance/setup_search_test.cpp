// What is tried until a history of cached light may begin.
#include "radiance/setup_search.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

constexpr int kFirst = 4;

TEST(SetupSearch, what_is_good_enough_ends_the_search) {
  SetupSearch search(true, kFirst);
  EXPECT_EQ(search.current().rounds, 4);
  EXPECT_FALSE(search.go_on({true, 0.5f, 0.1f}));
  ASSERT_TRUE(search.good());
  EXPECT_EQ(search.good()->rounds, 4);
}

TEST(SetupSearch, begins_with_the_rounds_that_it_is_told_and_few_have_to_be_far_better) {
  SetupSearch search(true, 2);
  EXPECT_EQ(search.current().rounds, 2);
  EXPECT_TRUE(search.go_on({true, 0.9f, 0.5f}));
  EXPECT_EQ(search.current().rounds, 4);
  EXPECT_FALSE(SetupSearch(true, 2).go_on({true, 0.9f, 0.3f}));
}

TEST(SetupSearch, cells_that_make_most_of_the_error_are_fed_more_though_frames_are_good) {
  SetupSearch search(true, kFirst);
  EXPECT_TRUE(search.go_on({true, 0.9f, 0.6f}));
  EXPECT_EQ(search.current().rounds, 8);
  EXPECT_FALSE(search.go_on({true, 0.8f, 0.6f}));
  EXPECT_EQ(search.good()->rounds, 8);
}

TEST(SetupSearch, stains_are_fed_more_though_frames_are_good) {
  SetupSearch search(true, kFirst);
  EXPECT_TRUE(search.go_on({.is_good = true, .excess = 0.9f, .of_cells = 0.1f, .is_stained = true}));
  EXPECT_EQ(search.current().rounds, 2 * kFirst);
  EXPECT_FALSE(search.go_on({.is_good = true, .excess = 0.5f, .of_cells = 0.1f}));
  EXPECT_EQ(search.good()->rounds, 2 * kFirst);
}

/// Where cells make 0.4 of the error, half of that leaves 0.8 to pixels in place of 0.6: (0.6 / 0.8)^(1 / 1.6) = 0.835 of
/// their samples.
TEST(SetupSearch, more_updates_pay_where_enough_frames_gain_by_them) {
  const SetupOutcome outcome{true, 0.9f, 0.4f};
  constexpr double kOfFrame = 1000.0;
  EXPECT_TRUE(updates_pay(outcome, kOfFrame, 82.0)) << "165 saved";
  EXPECT_FALSE(updates_pay(outcome, kOfFrame, 83.0));
  EXPECT_TRUE(updates_pay(outcome, 16 * kOfFrame, 1300.0));
  EXPECT_FALSE(updates_pay({true, 0.9f, 0.0f}, 16 * kOfFrame, 1.0)) << "cells err by nothing";
  EXPECT_TRUE(updates_pay({true, 0.9f, 1.0f}, kOfFrame, 300.0)) << "all of the error: 0.35 of the samples are left";
}

TEST(SetupSearch, far_from_good_four_times_the_updates_are_tried_at_once) {
  SetupSearch search(true, kFirst);
  ASSERT_TRUE(search.go_on({false, 8.0f, 1.0f}));
  EXPECT_EQ(search.current().rounds, 16);
  ASSERT_TRUE(search.go_on({false, 3.0f, 1.0f}));
  EXPECT_EQ(search.current().rounds, 32);
}

TEST(SetupSearch, updates_go_on_as_long_as_they_help) {
  SetupSearch search(false, kFirst);
  float excess = 3.9f;
  int rounds = 4;
  for (; search.current().rounds < 64; excess *= 0.5f) {
    EXPECT_EQ(search.current().rounds, rounds);
    ASSERT_TRUE(search.go_on({false, excess, 1.0f}));
    rounds *= 2;
  }
  EXPECT_EQ(search.current().cell, 1.0f);
}

TEST(SetupSearch, light_that_comes_straight_from_lamps_is_never_cached) {
  EXPECT_EQ(SetupSearch(true, kFirst).current().lights_from, LightGroup::kSky);
}

TEST(SetupSearch, the_sky_is_asked_where_updates_do_not_help_and_cells_shrink_where_that_does_not) {
  SetupSearch search(true, kFirst);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(search.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(search.current().rounds, 16);
  ASSERT_TRUE(search.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(search.current().lights_from, LightGroup::kEnd);
  EXPECT_EQ(search.current().cell, 1.0f);
  ASSERT_TRUE(search.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(search.current().lights_from, LightGroup::kSky);
  EXPECT_EQ(search.current().cell, 0.5f);
  EXPECT_FALSE(search.good());
}

TEST(SetupSearch, cells_shrink_where_there_is_no_sky_to_ask) {
  SetupSearch search(false, kFirst);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(search.go_on({false, 4.0f, 1.0f}));
  EXPECT_EQ(search.current().lights_from, LightGroup::kSky);
  EXPECT_EQ(search.current().cell, 0.5f);
}

TEST(SetupSearch, come_to_an_end_when_nothing_helps) {
  SetupSearch search(true, kFirst);
  int tried = 1;
  while (search.go_on({false, 4.0f, 1.0f})) ASSERT_LT(++tried, 10);
  EXPECT_FALSE(search.good());
}

}  // namespace
}  // namespace lippmann
