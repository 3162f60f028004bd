// Reading damaged video files must give frames or an error, and must not crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"
#include "support/command.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "video/video_reader.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::TempDir;

struct Outcome {
  int frames = 0, errors = 0;
};

void read_to_the_end(const fs::path& path, Outcome& outcome) {
  try {
    VideoReader reader(path);
    Vec2i size(0);
    while (const std::optional<Image8> frame = reader.next()) {
      if (size == Vec2i(0)) size = {frame->width, frame->height};
      ASSERT_EQ(Vec2i(frame->width, frame->height), size);
      ASSERT_EQ(frame->rgb.size(), 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
      ++outcome.frames;
    }
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(path.filename().string()));
    ++outcome.errors;
  }
}

/// `number` determines the kind and the position of the damage.
std::string damaged(std::string bytes, std::uint32_t number) {
  std::uint32_t drawn = 0;
  const auto draw = [&](std::size_t below) {
    return static_cast<std::size_t>(hash(number, drawn++)) % std::max<std::size_t>(below, 1);
  };
  const std::size_t at = draw(bytes.size()), count = 1 + draw(64), kind = draw(5);
  // Half of the damage is in the first 1024 bytes, where headers state sizes and pixel formats.
  const std::size_t reach = draw(2) == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 1024);
  if (kind == 0) bytes[draw(reach)] = static_cast<char>(draw(256));
  if (kind == 1)
    for (std::size_t i = 0; i < count; ++i) bytes[draw(reach)] = static_cast<char>(draw(256));
  if (kind == 2) bytes[draw(reach)] ^= static_cast<char>(1 << draw(8));
  if (kind == 3) bytes.erase(at, count);
  if (kind == 4) bytes.replace(at, std::min(count, bytes.size() - at), bytes.substr(draw(bytes.size()), count));
  return bytes;
}

struct Kind {
  const char* name;
  VideoCodec codec;
};

class EveryCodec : public testing::TestWithParam<Kind> {};

TEST_P(EveryCodec, damaged_files_give_frames_or_an_error) {
  const TempDir dir;
  VideoOptions options;
  options.codec = GetParam().codec;
  const fs::path path = dir / GetParam().name;
  {
    VideoWriter writer(path, options);
    for (int i = 0; i < 4; ++i) writer.add_frame(test::smooth_codes(72, 64, 0.1 * i));
    writer.finish();
  }
  const std::string whole = file_bytes(path);
  Outcome outcome;
  for (std::uint32_t number = 0; number < 250; ++number) {
    SCOPED_TRACE(number);
    std::ofstream(path, std::ios::binary) << damaged(whole, number);
    read_to_the_end(path, outcome);
  }
  EXPECT_GT(outcome.frames, 0);
  EXPECT_GT(outcome.errors, 0);
}

INSTANTIATE_TEST_SUITE_P(Video, EveryCodec,
                         testing::Values(Kind{"h264.mp4", VideoCodec::kH264}, Kind{"hevc.mov", VideoCodec::kHevc},
                                         Kind{"vp9.webm", VideoCodec::kVp9}, Kind{"ffv1.mkv", VideoCodec::kFfv1}),
                         [](const auto& codec) { return fs::path(codec.param.name).stem().string(); });

TEST(VideoReader, changes_of_the_frame_size_are_refused) {
  const TempDir dir;
  std::string bytes;
  for (const char* size : {"64x48", "96x80"}) {
    const fs::path part = dir / (std::string(size) + ".mjpeg");
    const auto made = test::run_command("ffmpeg -v error -f lavfi -i testsrc=size=" + std::string(size) +
                                        ":rate=5 -frames:v 2 -c:v mjpeg -f mjpeg '" + part.string() + "'");
    if (made.exit_code != 0) GTEST_SKIP() << "ffmpeg is not installed";
    bytes += file_bytes(part);
  }
  std::ofstream(dir / "a.mov", std::ios::binary) << bytes;
  EXPECT_THAT(test::error_message([&] {
                VideoReader reader(dir / "a.mov");
                while (reader.next()) {
                }
              }),
              testing::HasSubstr("a.mov: frame 2 has 96x80 pixels, and the frames before it have 64x48"));
}

}  // namespace
}  // namespace lippmann
