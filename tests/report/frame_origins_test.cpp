#include "report/frame_origins.hpp"

#include <gtest/gtest.h>

#include "report/reports.hpp"

namespace lippmann {
namespace {

using Shares = OriginShares;

RenderFigures render_of(const std::string& reuse) {
  RenderFigures render;
  render.reuse = reuse, render.pixels = test::kPixels;
  return render;
}

void expect_shares(const FrameReport& frame, const std::string& reuse, const Shares& expected) {
  const std::optional<Shares> shares = origins_of(frame, render_of(reuse));
  ASSERT_TRUE(shares);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR((*shares)[i], expected[i], 1e-12) << kOriginNames[i];
}

TEST(FrameOrigins, key_and_full_frames_are_traced) { expect_shares(test::key_frame(0), "interpolate", {1, 0, 0, 0}); }

TEST(FrameOrigins, copied_frames_trace_the_rest) { expect_shares(test::in_between_frame(1), "copy", {0.2, 0.8, 0, 0}); }

TEST(FrameOrigins, interpolated_frames_fill_the_rest) {
  expect_shares(test::in_between_frame(1), "interpolate", {0.15, 0, 0.8, 0.05});
}

TEST(FrameOrigins, shares_are_limited_to_the_frame) {
  FrameReport frame = test::in_between_frame(1);
  frame.reused_pixels = 70, frame.retraced_pixels = 1000;
  expect_shares(frame, "interpolate", {0.3, 0, 0.7, 0});
}

TEST(FrameOrigins, shares_need_the_frame_size) {
  RenderFigures render = render_of("copy");
  render.pixels.reset();
  EXPECT_FALSE(origins_of(test::in_between_frame(1), render));
}

TEST(FrameOrigins, savings_compare_with_fully_traced_frames) {
  RenderFigures render = render_of("copy");
  render.frames = {test::key_frame(0), test::in_between_frame(1), test::key_frame(2)};
  render.frames[2].cpu_seconds = 3.0;
  EXPECT_EQ(traced_cpu_seconds(render), 2.5);
  EXPECT_EQ(saving(0.5, traced_cpu_seconds(render)), 0.8);
  EXPECT_EQ(saving(5.0, 2.5), -1.0);
  EXPECT_FALSE(saving(0.5, std::nullopt));
}

}  // namespace
}  // namespace lippmann
