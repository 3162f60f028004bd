#include "distribute/units.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<int> frames(int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(Units, independent_frames_are_cut_evenly) {
  EXPECT_THAT(units_of(frames(7), 1, 3), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3, 4), ElementsAre(5, 6)));
}

TEST(Units, are_cut_only_between_segments) {
  EXPECT_THAT(units_of({2, 3, 4, 5, 8, 9, 12}, 4, 2), ElementsAre(ElementsAre(2, 3, 4, 5), ElementsAre(8, 9, 12)));
  EXPECT_THAT(units_of({2, 3, 4, 5, 8, 9, 12}, 4, 3), ElementsAre(ElementsAre(2, 3, 4, 5), ElementsAre(8, 9), ElementsAre(12)));
}

TEST(Units, are_at_most_one_per_segment) {
  EXPECT_THAT(units_of(frames(5), 16, 200), ElementsAre(ElementsAre(0, 1, 2, 3, 4)));
  EXPECT_THAT(units_of({}, 16, 200), IsEmpty());
  EXPECT_THAT(frames_of({{2}, 200}, frames(5), 16), IsEmpty());
}

TEST(Units, hold_every_frame_once) {
  for (const int segment : {1, 3, 16})
    for (int count = 1; count < 60; ++count) {
      std::vector<int> all;
      for (const std::vector<int>& unit : units_of(frames(50), segment, count)) {
        EXPECT_FALSE(unit.empty());
        EXPECT_EQ(unit.front() % segment, 0);
        all.insert(all.end(), unit.begin(), unit.end());
      }
      EXPECT_EQ(all, frames(50));
    }
}

TEST(Units, several_combine_their_frames) {
  EXPECT_THAT(frames_of({{1, 3}, 4}, frames(8), 1), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(frames_of({{2, 9}, 9}, frames(40), 16),
              ElementsAre(16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31));
}

TEST(Units, round_trip_and_refuse_others) {
  for (const char* text : {"7/200", "1-3,5/200"}) EXPECT_EQ(write_units(read_units(text, "unit")), text);
  for (const char* text : {"", "7", "0/3", "4/3", "-1/3", "1/0", "1/3x", "a/b", "1/2/3", "1/99999999", "0-3/3", "2-4/3"})
    EXPECT_THROW(read_units(text, "unit"), Error) << text;
}

}  // namespace
}  // namespace lippmann
