#include "reuse/frame_plan.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lippmann {
namespace {

TEST(FramePlan, every_fourth_and_last_frame_are_keys) {
  std::vector<int> keys;
  for (int frame = 0; frame <= 10; ++frame)
    if (is_key_frame(frame, 4, 10)) keys.push_back(frame);
  EXPECT_EQ(keys, (std::vector<int>{0, 4, 8, 10}));
}

TEST(FramePlan, interval_one_makes_every_frame_a_key) {
  for (int frame = 0; frame <= 3; ++frame) EXPECT_TRUE(is_key_frame(frame, 1, 3)) << frame;
}

TEST(FramePlan, in_between_frames_have_a_key_interval) {
  EXPECT_EQ(key_interval(1, 4, 10), (FrameInterval{0, 4}));
  EXPECT_EQ(key_interval(7, 4, 10), (FrameInterval{4, 8}));
  EXPECT_EQ(key_interval(9, 4, 10), (FrameInterval{8, 10}));
}

TEST(FramePlan, halving_prefers_the_earlier_middle) {
  EXPECT_EQ(middle_frame({0, 8}), 4);
  EXPECT_EQ(middle_frame({4, 7}), 5);
  EXPECT_EQ(middle_frame({4, 6}), 5);
}

TEST(FramePlan, path_lists_the_sources_of_halving) {
  EXPECT_EQ(halving_path(3, 8, 100), (std::vector<FrameInterval>{{0, 8}, {0, 4}, {2, 4}}));
  EXPECT_EQ(halving_path(4, 8, 100), (std::vector<FrameInterval>{{0, 8}}));
  EXPECT_EQ(halving_path(13, 8, 14), (std::vector<FrameInterval>{{8, 14}, {11, 14}, {12, 14}}));
}

TEST(FramePlan, depth_is_the_longest_path) {
  for (int every = 2; every <= 33; ++every) {
    std::size_t longest = 0;
    for (int frame = 1; frame < every; ++frame) longest = std::max(longest, halving_path(frame, every, 1000).size());
    EXPECT_EQ(halving_depth(every), static_cast<int>(longest)) << every;
  }
}

}  // namespace
}  // namespace lippmann
