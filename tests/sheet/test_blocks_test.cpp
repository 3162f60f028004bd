#include "sheet/test_blocks.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

constexpr auto kVertical = BarDirection::kVertical, kHorizontal = BarDirection::kHorizontal;

bool is_black_at(const BlockTest& test, int x, int y) {
  const auto& image = std::get<Image8>(test.picture);
  return image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x))] ==
         0;
}

int bars_of(const BlockTest& test, const TestBlock& block, BarDirection direction) {
  const Vec2i middle = (block.bars.from + block.bars.to) / 2;
  const bool is_vertical = direction == kVertical;
  const int from = is_vertical ? block.bars.from.x : block.bars.from.y, to = is_vertical ? block.bars.to.x : block.bars.to.y;
  int bars = 0;
  for (int i = from; i < to; ++i) {
    const auto is_black = [&](int at) {
      return is_vertical ? is_black_at(test, at, middle.y) : is_black_at(test, middle.x, at);
    };
    if (is_black(i) && (i == from || !is_black(i - 1))) ++bars;
  }
  return bars;
}

bool has_ink(const BlockTest& test, const PixelBox& box) {
  for (int y = box.from.y; y < box.to.y; ++y)
    for (int x = box.from.x; x < box.to.x; ++x)
      if (is_black_at(test, x, y)) return true;
  return false;
}

class PitchTest : public testing::TestWithParam<BarDirection> {};
INSTANTIATE_TEST_SUITE_P(Directions, PitchTest, testing::Values(kVertical, kHorizontal));

TEST_P(PitchTest, has_21_labelled_blocks_around_9_6_pixels) {
  const ThreadPool pool(2);
  const bool is_vertical = GetParam() == kVertical;
  const Display sheet = load_display(is_vertical ? "lpi=62.5 dpi=600 paper=A6" : "lpi=62.5 dpi=600 paper=A5 landscape");
  const BlockTest test = pitch_test(sheet, 21, {}, GetParam(), pool);
  ASSERT_EQ(test.blocks.size(), 21u);
  for (int i = 0; i < 21; ++i) {
    const TestBlock& block = test.blocks[static_cast<std::size_t>(i)];
    EXPECT_NEAR(block.pitch_px, 8.6 + 0.1 * i, 1e-9);
    EXPECT_EQ(block.is_nominal, i == 10);
    const int room = is_vertical ? block.bars.size().x : block.bars.size().y;
    EXPECT_EQ(bars_of(test, block, GetParam()), static_cast<int>(std::floor((room - 0.5) / block.pitch_px)) + 1)
        << i << ": the last pixel's centre lies half a pixel before the end";
    const PixelBox label = is_vertical ? PixelBox{{0, block.bars.from.y}, {block.bars.from.x, block.bars.to.y}}
                                       : PixelBox{{block.bars.from.x, 0}, {block.bars.to.x, block.bars.from.y}};
    EXPECT_TRUE(has_ink(test, label)) << i;
    if (i > 0) {
      const TestBlock& before = test.blocks[static_cast<std::size_t>(i - 1)];
      EXPECT_GT(is_vertical ? block.bars.from.y : block.bars.from.x, is_vertical ? before.bars.to.y : before.bars.to.x);
    }
  }
}

TEST(PitchBlocks, whole_pitch_alternates_by_half_a_pitch) {
  const ThreadPool pool(1);
  const BlockTest test = pitch_test(load_display("lpi=100 dpi=800 paper=900x900px"), 3, {2.0}, kVertical, pool);
  const TestBlock& block = test.blocks[1];
  ASSERT_EQ(block.pitch_px, 8.0);
  for (int x = block.bars.from.x; x < block.bars.to.x; ++x)
    ASSERT_EQ(is_black_at(test, x, block.bars.from.y), (x - block.bars.from.x) % 8 < 4) << x;
}

TEST(PitchBlocks, steps_may_be_lenses_per_inch) {
  const ThreadPool pool(1);
  const BlockTest test = pitch_test(load_display("lpi=60 dpi=600 paper=A6"), 5, read_pitch_step("0.5lpi"), kVertical, pool);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(test.blocks[static_cast<std::size_t>(i)].pitch_px, 600.0 / (59.0 + 0.5 * i), 1e-9);
}

TEST(PitchBlocks, print_pitch_follows_from_the_viewing_distance) {
  const ThreadPool pool(1);
  const Display sheet = load_display("lpi=60 dpi=600 paper=A6 viewing-distance=500");
  EXPECT_GT(lens_strips(sheet).cell_px, 10.005);
  EXPECT_EQ(pitch_test(sheet, 3, {}, kVertical, pool).blocks[1].pitch_px, lens_strips(sheet).cell_px);
}

TEST(PitchBlocks, refuse_unprintable_values) {
  const ThreadPool pool(1);
  const Display sheet = load_display("lpi=60 dpi=150 paper=A6");
  EXPECT_THAT(error_message([&] { pitch_test(sheet, 21, {}, kVertical, pool); }),
              HasSubstr("block 1 of 21 a pitch of 1.5 pixels"));
  EXPECT_THAT(error_message([&] {
                pitch_test(sheet, 3, {90.0, PitchStep::Unit::kLensesPerInch}, kVertical, pool);
              }),
              HasSubstr("block 1 of 3"));
  EXPECT_THAT(error_message([&] { pitch_test(sheet, 200, {0.001}, kVertical, pool); }), HasSubstr("200 labelled blocks"));
  EXPECT_THAT(error_message([] { read_pitch_step("0.1"); }), HasSubstr("no unit"));
  EXPECT_THAT(error_message([] { read_pitch_step("xlpi"); }), HasSubstr("step"));
}

TEST(PhaseBlocks, are_white_in_the_middle_of_strips) {
  const ThreadPool pool(2);
  const BlockTest test = phase_test(load_display("lpi=100 dpi=1200 paper=1200x900px"), 6, kVertical, pool);
  ASSERT_EQ(test.blocks.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const TestBlock& block = test.blocks[static_cast<std::size_t>(i)];
    EXPECT_EQ(block.phase_px, 2.0 * i);
    for (int x = block.bars.from.x; x < block.bars.to.x; ++x) {
      const int place = (x - 2 * i + 12) % 12;
      ASSERT_EQ(is_black_at(test, x, block.bars.from.y), place < 4 || place >= 8) << i << ' ' << x;
    }
  }
}

TEST(PhaseBlocks, do_not_depend_on_threads) {
  const Display sheet = load_display("lpi=60.12 dpi=300 paper=A6");
  const auto made = [&](int threads) {
    const ThreadPool pool(threads);
    return std::get<Image8>(phase_test(sheet, 7, kHorizontal, pool).picture).rgb;
  };
  EXPECT_EQ(made(1), made(3));
}

}  // namespace
}  // namespace lippmann
