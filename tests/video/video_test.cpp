#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "lippmann/image/metrics.hpp"
#include "support/command.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/file_size_limit.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "video/video_reader.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::file_bytes;
using test::noise_codes;
using test::smooth_codes;
using test::TempDir;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

void write_video(const fs::path& path, const std::vector<Image8>& frames, const VideoOptions& options = {}) {
  VideoWriter writer(path, options);
  for (const Image8& frame : frames) writer.add_frame(frame);
  writer.finish();
}

std::vector<Image8> read_video(const fs::path& path) {
  VideoReader reader(path);
  std::vector<Image8> frames;
  while (std::optional<Image8> frame = reader.next()) frames.push_back(std::move(*frame));
  return frames;
}

std::vector<Image8> noise_frames(int count, int width, int height) {
  std::vector<Image8> frames;
  for (int i = 0; i < count; ++i) frames.push_back(noise_codes(width, height, 100 + i));
  return frames;
}

std::vector<Image8> smooth_frames(int count, int width, int height) {
  std::vector<Image8> frames;
  for (int i = 0; i < count; ++i) frames.push_back(smooth_codes(width, height, 0.1 * i));
  return frames;
}

std::string probe(const fs::path& path, const std::string& entries) {
  return test::run_command("ffprobe -v error -select_streams v -show_entries " + entries + " -of default=noprint_wrappers=1 '" +
                           path.string() + "'")
      .output;
}

TEST(Video, ffv1_round_trips_all_sizes_in_order) {
  const TempDir dir;
  for (const auto& [width, height] : {std::pair{64, 48}, {37, 21}, {2, 2}}) {
    const std::vector<Image8> frames = noise_frames(5, width, height);
    write_video(dir / "a.mkv", frames);
    const std::vector<Image8> read = read_video(dir / "a.mkv");
    ASSERT_EQ(read.size(), 5u);
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(read[i].width, width);
      EXPECT_EQ(read[i].rgb, frames[i].rgb) << "frame " << i;
    }
  }
}

TEST(Video, h264_keeps_smooth_pictures_above_40_db) {
  const TempDir dir;
  const std::vector<Image8> frames = smooth_frames(12, 128, 96);
  write_video(dir / "a.mp4", frames);
  const std::vector<Image8> read = read_video(dir / "a.mp4");
  ASSERT_EQ(read.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_GT(measure_difference(frames[i], read[i]).psnr_db, 40.0) << i;
    if (i == 0) continue;
    EXPECT_LT(measure_difference(frames[i - 1], read[i]).psnr_db, 35.0) << "neighbouring frames differ more";
  }
}

struct CodecFile {
  const char* file;
  VideoCodec codec;
  const char* probed;
};
const std::vector<CodecFile> kLossyFiles{{"a.mp4", VideoCodec::kH264, "h264"}, {"a.mov", VideoCodec::kH264, "h264"},
                                         {"b.mp4", VideoCodec::kHevc, "hevc"}, {"b.mov", VideoCodec::kHevc, "hevc"},
                                         {"c.webm", VideoCodec::kVp9, "vp9"},  {"c.mkv", VideoCodec::kVp9, "vp9"},
                                         {"d.webm", VideoCodec::kAv1, "av1"},  {"d.mp4", VideoCodec::kAv1, "av1"}};

/// Other builds of FFmpeg than Debian's may lack encoders.
bool has_encoder(VideoCodec codec) {
  try {
    choose_codec("a.mkv", codec, 0, 0);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(Video, every_codec_keeps_smooth_pictures_above_38_db) {
  const TempDir dir;
  std::vector<Image8> frames;
  for (int i = 0; i < 9; ++i) frames.push_back(smooth_codes(130, 95, 0.2 * i));  // the odd height is padded to 96 rows
  for (const CodecFile& file : kLossyFiles) {
    if (!has_encoder(file.codec)) continue;
    write_video(dir / file.file, frames, {.codec = file.codec});
    const std::vector<Image8> read = read_video(dir / file.file);
    ASSERT_EQ(read.size(), frames.size()) << file.file;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      ASSERT_EQ(read[i].height, 96);
      Image8 shown{130, 95, {read[i].rgb.begin(), read[i].rgb.end() - 3 * 130}};
      EXPECT_GT(measure_difference(frames[i], shown).psnr_db, 38.0) << file.file << " " << i;
      if (i == 0) continue;
      EXPECT_LT(measure_difference(frames[i - 1], shown).psnr_db, 35.0) << "neighbouring frames differ more";
    }
  }
}

TEST(Video, every_codec_gives_equal_bytes_for_equal_frames) {
  const TempDir dir;
  const std::vector<Image8> frames = smooth_frames(6, 96, 64);
  for (const CodecFile& file : kLossyFiles) {
    if (!has_encoder(file.codec)) continue;
    for (const int threads : {1, 4}) {
      write_video(dir / file.file, frames, {.codec = file.codec, .threads = threads});
      const std::string first = file_bytes(dir / file.file);
      write_video(dir / file.file, frames, {.codec = file.codec, .threads = threads});
      EXPECT_EQ(file_bytes(dir / file.file), first) << file.file << " " << threads;
    }
  }
}

// Encoders reorder more frames than such a video has, and FFmpeg's muxers refuse the resulting decoding times.
TEST(Video, files_of_one_to_three_frames_are_written) {
  const TempDir dir;
  for (const CodecFile& file : kLossyFiles) {
    if (!has_encoder(file.codec)) continue;
    for (int count = 1; count <= 3; ++count) {
      const fs::path path = dir / fmt::format("{}_{}", count, file.file);
      write_video(path, smooth_frames(count, 96, 64), {.codec = file.codec});
      if (!test::program_exists("ffprobe")) continue;
      const std::string packets =
          test::run_command("ffprobe -v error -count_frames -show_entries stream=nb_read_frames '" + path.string() + "'")
              .output;
      EXPECT_THAT(packets, HasSubstr(fmt::format("nb_read_frames={}", count))) << path;
    }
  }
}

TEST(Video, files_state_their_codec_and_colours) {
  if (!test::program_exists("ffprobe")) GTEST_SKIP() << "ffprobe (package ffmpeg) is not installed";
  const TempDir dir;
  for (const CodecFile& file : kLossyFiles) {
    if (!has_encoder(file.codec)) continue;
    write_video(dir / file.file, smooth_frames(3, 96, 64), {.codec = file.codec});
    const std::string found = probe(dir / file.file, "stream=codec_name,pix_fmt,color_range,color_space,codec_tag_string");
    EXPECT_THAT(found, AllOf(HasSubstr(std::string("codec_name=") + file.probed), HasSubstr("pix_fmt=yuv420p"),
                             HasSubstr("color_range=tv"), HasSubstr("color_space=bt709")))
        << file.file;
    if (file.codec == VideoCodec::kHevc) {
      EXPECT_THAT(found, HasSubstr("codec_tag_string=hvc1"));
    }
  }
}

std::string probe_stereo(const fs::path& path, VideoCodec codec, const StereoLayout& stereo) {
  write_video(path, smooth_frames(2, 96, 64), {.codec = codec, .stereo = stereo});
  return test::run_command("ffprobe -v error -show_streams '" + path.string() + "'").output;
}

/// Returns the stereo mode in the st3d box of an MP4 file (Google's Spherical Video V2), or -1. ffprobe 7 would prefer
/// the vexu box that FFmpeg also writes for HEVC.
int stereo_mode_of_mp4(const fs::path& path) {
  const std::string file = file_bytes(path);
  const std::size_t at = file.find("st3d");
  return at == std::string::npos || at + 8 >= file.size() ? -1 : file[at + 8];
}

TEST(Video, stereo_files_state_their_packing) {
  if (!test::program_exists("ffprobe")) GTEST_SKIP() << "ffprobe (package ffmpeg) is not installed";
  const TempDir dir;
  const StereoLayout sbs{}, half{StereoPacking::kHalfSideBySide}, over{StereoPacking::kOverUnder}, rows{StereoPacking::kRows},
      right{StereoPacking::kSideBySide, true};
  const fs::path mkv = dir / "a.mkv", mp4 = dir / "a.mp4";
  EXPECT_THAT(probe_stereo(mkv, VideoCodec::kFfv1, sbs),
              AllOf(HasSubstr("type=side by side"), HasSubstr("inverted=0"), HasSubstr("sample_aspect_ratio=1:1")));
  EXPECT_THAT(probe_stereo(mkv, VideoCodec::kFfv1, half),
              AllOf(HasSubstr("type=side by side"), HasSubstr("sample_aspect_ratio=2:1")));
  EXPECT_THAT(probe_stereo(mkv, VideoCodec::kFfv1, over), HasSubstr("type=top and bottom"));
  EXPECT_THAT(probe_stereo(mkv, VideoCodec::kFfv1, rows), HasSubstr("type=interleaved lines"));
  EXPECT_THAT(probe_stereo(mkv, VideoCodec::kFfv1, right), AllOf(HasSubstr("type=side by side"), HasSubstr("inverted=1")));
  probe_stereo(mp4, VideoCodec::kHevc, sbs);
  EXPECT_EQ(stereo_mode_of_mp4(mp4), 2) << "left to right";
  probe_stereo(mp4, VideoCodec::kHevc, over);
  EXPECT_EQ(stereo_mode_of_mp4(mp4), 1) << "top to bottom";
  write_video(mkv, smooth_frames(2, 96, 64));
  EXPECT_THAT(test::run_command("ffprobe -v error -show_streams '" + mkv.string() + "'").output,
              Not(HasSubstr("side by side")));
}

TEST(Video, h264_streams_state_the_stereo_packing) {
  if (!test::program_exists("ffprobe")) GTEST_SKIP() << "ffprobe (package ffmpeg) is not installed";
  if (!has_encoder(VideoCodec::kH264)) GTEST_SKIP() << "no encoder of H.264";
  const TempDir dir;
  write_video(dir / "a.mov", smooth_frames(2, 96, 64), {.codec = VideoCodec::kH264, .stereo = StereoLayout{}});
  const std::string frames = test::run_command("ffprobe -v error -show_frames '" + (dir / "a.mov").string() + "'").output;
  EXPECT_THAT(frames, HasSubstr("Stereo 3D"));
}

TEST(ChooseCodec, extension_and_size_decide_by_default) {
  EXPECT_EQ(choose_codec("a.mp4", {}, 4096, 4096), VideoCodec::kH264);
  EXPECT_EQ(choose_codec("a.mp4", {}, 4098, 16), VideoCodec::kHevc);
  EXPECT_EQ(choose_codec("a.mov", {}, 16, 5999), VideoCodec::kHevc);
  EXPECT_EQ(choose_codec("a.webm", {}, 8192, 8192), VideoCodec::kVp9);
  EXPECT_EQ(choose_codec("a.mkv", {}, 16384, 16384), VideoCodec::kFfv1);
}

TEST(ChooseCodec, unsupported_combinations_are_refused) {
  const auto refusal = [](const char* file, std::optional<VideoCodec> codec, int side) {
    return error_message([&] { choose_codec(file, codec, side, 16); });
  };
  EXPECT_THAT(refusal("a.mp4", VideoCodec::kH264, 4098),
              AllOf(HasSubstr("4096"), HasSubstr("4098"), HasSubstr("hevc, vp9, av1")));
  EXPECT_THAT(refusal("a.mp4", {}, 8194), AllOf(HasSubstr("8192"), HasSubstr("vp9, av1")));
  EXPECT_THAT(refusal("a.mov", {}, 8194), HasSubstr("smaller frames"));
  EXPECT_THAT(refusal("a.mp4", VideoCodec::kFfv1, 16),
              AllOf(HasSubstr("cannot contain ffv1"), HasSubstr("h264, hevc, vp9, av1")));
  EXPECT_THAT(refusal("a.webm", VideoCodec::kH264, 16), HasSubstr("vp9, av1"));
}

TEST(Video, h264_keeps_colours_of_flat_fields) {
  const TempDir dir;
  std::vector<Image8> frames;
  for (int color = 0; color < 8; ++color) {
    Image8 frame{32, 32, {}};
    for (int i = 0; i < 32 * 32; ++i)
      for (int c = 0; c < 3; ++c) frame.rgb.push_back(color >> c & 1 ? 230 : 20);
    frames.push_back(frame);
  }
  write_video(dir / "a.mp4", frames, {.crf = 1});
  const std::vector<Image8> read = read_video(dir / "a.mp4");
  for (int color = 0; color < 8; ++color)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(read[color].rgb[3 * (16 * 32 + 16) + c], frames[color].rgb[c], 3)
          << "rounding to 219 levels of Y and 224 of Cb, Cr: at most 1.86 / 2 of Cb + .4 of Y, and as much again from coding";
}

TEST(Video, h264_pads_odd_sides_with_the_border) {
  const TempDir dir;
  const Image8 frame = smooth_codes(45, 31);
  write_video(dir / "a.mp4", {frame}, {.crf = 1});
  const Image8 read = read_video(dir / "a.mp4").at(0);
  ASSERT_EQ(read.width, 46);
  ASSERT_EQ(read.height, 32);
  Image8 padded{46, 32, {}};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 46; ++x)
      for (int c = 0; c < 3; ++c) padded.rgb.push_back(frame.rgb[3 * (std::min(y, 30) * 45 + std::min(x, 44)) + c]);
  EXPECT_GT(measure_difference(padded, read).psnr_db, 40.0);
}

TEST(Video, equal_frames_give_equal_bytes) {
  const TempDir dir;
  const std::vector<Image8> frames = smooth_frames(6, 64, 48);
  for (const auto& [first, second] : {std::pair{"a.mp4", "b.mp4"}, {"a.mkv", "b.mkv"}})
    for (const int threads : {1, 3}) {
      write_video(dir / first, frames, {.threads = threads});
      write_video(dir / second, frames, {.threads = threads});
      EXPECT_EQ(file_bytes(dir / first), file_bytes(dir / second)) << first << " " << threads;
    }
}

TEST(Video, h264_bytes_do_not_depend_on_freed_memory) {
  const TempDir dir;
  std::vector<Image8> frames(12, {144, 48, {}});
  for (int f = 0; f < 12; ++f)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 144; ++x)
        for (const int code : {4 * x, 5 * y + 3 * f, (x * x + 17 * y * f) / 8})
          frames[static_cast<std::size_t>(f)].rgb.push_back(static_cast<unsigned char>(code));
  write_video(dir / "first.mp4", frames, {});
  for (std::size_t run = 1; run < 20; ++run) {
    std::vector<std::vector<unsigned char>> filled_and_freed;
    for (std::size_t i = 0; i < 8; ++i)
      filled_and_freed.emplace_back(1000 + (7919 * run + 104729 * i) % 300000, static_cast<unsigned char>(31 * run + 7 * i));
    filled_and_freed.clear();
    write_video(dir / "again.mp4", frames, {});
    ASSERT_EQ(file_bytes(dir / "again.mp4"), file_bytes(dir / "first.mp4")) << "run " << run;
  }
}

TEST(Video, ffv1_bytes_do_not_depend_on_encoder_threads) {
  const TempDir dir;
  const std::vector<Image8> frames = noise_frames(3, 64, 48);
  write_video(dir / "a.mkv", frames, {.threads = 1});
  write_video(dir / "b.mkv", frames, {.threads = 4});
  EXPECT_EQ(file_bytes(dir / "a.mkv"), file_bytes(dir / "b.mkv"));
}

TEST(Video, h264_is_tagged_bt709_with_rate_and_index) {
  if (!test::program_exists("ffprobe")) GTEST_SKIP() << "ffprobe (package ffmpeg) is not installed";
  const TempDir dir;
  write_video(dir / "a.mp4", smooth_frames(10, 64, 48), {.rate = {30000, 1001}});
  const std::string found =
      probe(dir / "a.mp4",
            "stream=codec_name,pix_fmt,color_range,color_space,color_transfer,color_primaries,avg_frame_rate,nb_frames");
  EXPECT_THAT(found,
              AllOf(HasSubstr("codec_name=h264"), HasSubstr("pix_fmt=yuv420p"), HasSubstr("color_range=tv"),
                    HasSubstr("color_space=bt709"), HasSubstr("color_transfer=bt709"), HasSubstr("color_primaries=bt709"),
                    HasSubstr("avg_frame_rate=30000/1001"), HasSubstr("nb_frames=10")));
  const std::string bytes = file_bytes(dir / "a.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Video, psnr_agrees_with_ffmpegs_filter) {
  if (!test::program_exists("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const TempDir dir;
  const Image8 a = smooth_codes(96, 64), b = smooth_codes(96, 64, 0.07);
  write_video(dir / "a.mkv", {a});
  write_video(dir / "b.mkv", {b});
  const std::string output = test::run_command("ffmpeg -v info -i '" + (dir / "b.mkv").string() + "' -i '" +
                                               (dir / "a.mkv").string() + "' -lavfi psnr -f null -")
                                 .output;
  const PictureMetrics m = measure_difference(a, b);
  EXPECT_NEAR(test::number_after(output, "average:"), m.psnr_db, 0.01) << output;
  EXPECT_NEAR(test::number_after(output, "PSNR r:"), psnr_db(m.mse.r), 0.01) << output;
}

TEST(Video, ffmpeg_decodes_lossless_files_exactly) {
  if (!test::program_exists("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const TempDir dir;
  const Image8 frame = noise_codes(40, 30);
  write_video(dir / "a.mkv", {frame});
  ASSERT_EQ(test::run_command("ffmpeg -v error -i '" + (dir / "a.mkv").string() + "' -f rawvideo -pix_fmt rgb24 '" +
                              (dir / "a.rgb").string() + "'")
                .exit_code,
            0);
  EXPECT_EQ(file_bytes(dir / "a.rgb"), std::string(frame.rgb.begin(), frame.rgb.end()));
}

TEST(VideoWriter, unfinished_leaves_nothing) {
  const TempDir dir;
  for (const char* name : {"a.mp4", "a.mkv"}) {
    VideoWriter writer(dir / name);
    writer.add_frame(smooth_codes(32, 32));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(VideoWriter, unknown_extension_lists_the_known_ones) {
  const TempDir dir;
  for (const char* name : {"a.avi", "a", "a.png"})
    EXPECT_THAT(error_message([&] { VideoWriter(dir / name); }), AllOf(HasSubstr(name), HasSubstr(".mp4"), HasSubstr(".mkv")));
}

TEST(VideoWriter, missing_folder_fails_before_the_first_frame) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "none/a.mp4"); }), HasSubstr("there is no folder"));
  EXPECT_THAT(error_message([&] { check_video_path(dir / "none/a.mp4"); }), HasSubstr("there is no folder"));
  check_video_path(dir / "a.mp4");
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(VideoWriter, frame_of_another_size_is_named) {
  const TempDir dir;
  VideoWriter writer(dir / "a.mp4");
  writer.add_frame(smooth_codes(32, 32));
  EXPECT_THAT(error_message([&] { writer.add_frame(smooth_codes(32, 34)); }), HasSubstr("frame 1 has 32 x 34 pixels"));
}

TEST(VideoWriter, mkv_refuses_one_pixel_and_mp4_pads_it) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { write_video(dir / "a.mkv", {noise_codes(1, 8)}); }), HasSubstr("at least 2 pixels"));
  write_video(dir / "a.mp4", {noise_codes(1, 1)});
  EXPECT_EQ(read_video(dir / "a.mp4").at(0).width, 2);
}

TEST(VideoWriter, invalid_options_are_errors) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "a.mp4", {.rate = {0, 1}}); }), HasSubstr("frames per second"));
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "a.mp4", {.crf = 52}); }), HasSubstr("0 to 51"));
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "a.webm", {.crf = 64}); }), HasSubstr("0 to 63"));
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "a.mkv", {.crf = 5}); }), HasSubstr("is lossless"));
  EXPECT_THAT(error_message([&] { VideoWriter(dir / "a.mp4").finish(); }), HasSubstr("without frames"));
}

TEST(VideoWriter, full_disk_names_the_file_and_leaves_nothing) {
  const TempDir dir;
  const std::vector<Image8> frames = noise_frames(8, 128, 128);
  for (const char* name : {"a.mp4", "a.mkv"}) {
    const test::FileSizeLimit full(20000);
    EXPECT_THAT(error_message([&] { write_video(dir / name, frames); }),
                AllOf(HasSubstr(name), HasSubstr("cannot be written")));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(VideoReader, missing_file_folder_and_text_are_errors) {
  const TempDir dir;
  std::ofstream(dir / "text.mp4") << "this is not a video";
  std::ofstream(dir / "empty.mkv").flush();
  EXPECT_THAT(error_message([&] { VideoReader(dir / "none.mp4"); }), HasSubstr("there is no such file"));
  EXPECT_THAT(error_message([&] { VideoReader{dir.path()}; }), HasSubstr("is not a regular file but a folder"));
  EXPECT_THAT(error_message([&] { VideoReader(dir / "text.mp4"); }), HasSubstr("cannot be read as a video"));
  EXPECT_THAT(error_message([&] { VideoReader(dir / "empty.mkv"); }), HasSubstr("cannot be read as a video"));
}

TEST(VideoReader, truncated_files_are_errors) {
  const TempDir dir;
  const std::vector<Image8> frames = noise_frames(8, 64, 64);
  for (const auto& [whole, part] : {std::pair{"whole.mp4", "cut.mp4"}, {"whole.mkv", "cut.mkv"}}) {
    write_video(dir / whole, frames);
    const std::string bytes = file_bytes(dir / whole);
    for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
      const fs::path cut = dir / part;
      std::ofstream(cut, std::ios::binary) << bytes.substr(0, static_cast<std::size_t>(bytes.size() * share));
      EXPECT_THAT(error_message([&] { read_video(cut); }), HasSubstr("cut")) << part << " " << share;
    }
  }
}

TEST(FrameRate, whole_and_broadcast_rates_are_exact) {
  const auto is = [](double fps, int numerator, int denominator) {
    const FrameRate rate = frame_rate(fps);
    EXPECT_EQ(rate.numerator, numerator) << fps;
    EXPECT_EQ(rate.denominator, denominator) << fps;
  };
  is(25.0, 25, 1);
  is(29.97, 30000, 1001);
  is(23.976, 24000, 1001);
  is(30000.0 / 1001.0, 30000, 1001);
  is(12.5, 25, 2);
  is(0.5, 1, 2);
}

TEST(IsVideoName, extensions_in_any_case) {
  EXPECT_TRUE(is_video_name("a/b.mp4"));
  EXPECT_TRUE(is_video_name("b.MKV"));
  EXPECT_FALSE(is_video_name("b.png"));
  EXPECT_FALSE(is_video_name("mp4"));
}

}  // namespace
}  // namespace lippmann
