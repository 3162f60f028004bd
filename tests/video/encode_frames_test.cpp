#include "video/encode_frames.hpp"

#include <gmock/gmock.h>

#include "image/png.hpp"
#include "support/error_message.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::noise_codes;
using test::TempDir;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

void write_frames(const TempDir& dir, const std::vector<std::string>& names) {
  unsigned seed = 1;
  for (const std::string& name : names) write_png(dir / name, noise_codes(16, 8, seed++));
}

std::vector<int> numbers(const std::vector<NumberedFrame>& frames) {
  std::vector<int> all;
  for (const NumberedFrame& frame : frames) all.push_back(frame.number);
  return all;
}

TEST(FindFrames, folder_gives_numbered_frames_only) {
  const TempDir dir;
  write_frames(dir, {"frame_0010.png", "frame_0009.png", "frame_0011.png", "aov_0009.png", "cover.png"});
  const std::vector<NumberedFrame> frames = find_frames(dir.path());
  EXPECT_THAT(numbers(frames), ElementsAre(9, 10, 11));
  EXPECT_EQ(frames[0].path.filename(), "frame_0009.png");
  EXPECT_THAT(numbers(find_frames(dir.path(), {10, 11})), ElementsAre(10, 11));
}

TEST(FindFrames, patterns_name_one_series) {
  const TempDir dir;
  write_frames(dir, {"v0_1.png", "v0_2.png", "w(1).png", "w(2).png", "w(x).png", "x_1.png"});
  EXPECT_THAT(numbers(find_frames((dir / "v0_%03d.png").string())), ElementsAre(1, 2));
  EXPECT_THAT(numbers(find_frames((dir / "w(*).png").string())), ElementsAre(1, 2));
  EXPECT_THAT(error_message([&] { find_frames(dir.path()); }), HasSubstr("several series"));
  EXPECT_THAT(error_message([&] { find_frames((dir / "v*_%d.png").string()); }), HasSubstr("two placeholders"));
  EXPECT_THAT(error_message([&] { find_frames((dir / "none").string()); }), HasSubstr("is neither a folder nor a pattern"));
  EXPECT_THAT(error_message([&] { find_frames((dir / "z_*.png").string()); }), HasSubstr("no frames"));
}

TEST(FindFrames, missing_frames_are_named) {
  const TempDir dir;
  write_frames(dir, {"frame_0000.png", "frame_0001.png", "frame_0003.png"});
  EXPECT_THAT(error_message([&] { find_frames(dir.path()); }), AllOf(HasSubstr("frame 2 is missing"), HasSubstr("0 to 3")));
  EXPECT_THAT(error_message([&] { find_frames(dir.path(), {0, 1, 2, 3, 4}); }), HasSubstr("frame 2"));
  EXPECT_THAT(numbers(find_frames(dir.path(), {0, 1})), ElementsAre(0, 1));
  write_frames(dir, {"frame_02.png", "frame_2.png"});
  EXPECT_THAT(error_message([&] { find_frames(dir.path()); }), HasSubstr("two pictures for frame 2"));
}

TEST(VideoPath, quilts_give_their_name_to_the_video) {
  const TempDir dir;
  write_frames(dir, {"frame_0000_qs8x6a0.75.png", "frame_0001_qs8x6a0.75.png"});
  const std::vector<NumberedFrame> frames = find_frames(dir.path());
  EXPECT_THAT(numbers(frames), ElementsAre(0, 1));
  EXPECT_EQ(video_path("out/room.mp4", frames), "out/room_qs8x6a0.75.mp4");
  EXPECT_EQ(video_path("room_qs4x12a1.mp4", frames), "room_qs4x12a1.mp4");
}

TEST(EncodeFrames, lossless_video_keeps_the_order_and_reports_progress) {
  const TempDir dir;
  write_frames(dir, {"frame_0000.png", "frame_0001.png", "frame_0002.png"});
  std::vector<int> seen;
  EXPECT_TRUE(
      encode_frames(find_frames(dir.path()), dir / "a.mkv", {}, {}, [&](const NumberedFrame& f) { seen.push_back(f.number); }));
  EXPECT_THAT(seen, ElementsAre(0, 1, 2));
  VideoReader reader(dir / "a.mkv");
  for (unsigned seed = 1; seed <= 3; ++seed) EXPECT_EQ(reader.next()->rgb, noise_codes(16, 8, seed).rgb);
  EXPECT_FALSE(reader.next());
}

TEST(EncodeFrames, cancelled_or_failed_leaves_no_file) {
  const TempDir dir;
  write_frames(dir, {"frame_0000.png"});
  write_png(dir / "frame_0001.png", noise_codes(8, 8));
  Context cancelled;
  cancelled.cancelled = true;
  EXPECT_FALSE(encode_frames(find_frames(dir.path(), {0}), dir / "a.mkv", {}, cancelled));
  EXPECT_THAT(error_message([&] { encode_frames(find_frames(dir.path()), dir / "a.mkv", {}, {}); }), HasSubstr("8 x 8"));
  EXPECT_FALSE(fs::exists(dir / "a.mkv"));
}

TEST(EncodeFrames, turned_clockwise_by_three_quarters) {
  const TempDir dir;
  const Image8 frame = noise_codes(16, 8, 1);
  write_png(dir / "frame_0000.png", frame);
  ASSERT_TRUE(encode_frames(find_frames(dir.path()), dir / "a.mkv", {}, {}, {}, 270));
  VideoReader reader(dir / "a.mkv");
  const auto turned = reader.next();
  ASSERT_TRUE(turned);
  ASSERT_EQ(turned->width, 8);
  ASSERT_EQ(turned->height, 16);
  // Three quarter turns clockwise move the top right pixel to the top left.
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 16; ++y)
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(turned->rgb[static_cast<std::size_t>(3 * (y * 8 + x) + c)],
                  frame.rgb[static_cast<std::size_t>(3 * (x * 16 + 15 - y) + c)]);
}

}  // namespace
}  // namespace lippmann
