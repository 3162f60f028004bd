#include "lippmann/stage/environment_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"
#include "support/exr_file.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::TempDir;
using testing::ElementsAre;
using testing::HasSubstr;

void write_panorama(const std::filesystem::path& path, const test::ExrPart& part) {
  const std::vector<std::byte> file = test::exr_file(part);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
}

// The data window, a quarter of the panorama, must not be stretched over the sky.
TEST(EnvironmentFile, data_window_lies_in_the_display_window) {
  const TempDir dir;
  write_panorama(dir / "a.exr", {{1, 0, 1, 0}, {0, 0, 1, 1}, {{"b", {3}}, {"g", {2}}, {"r", {1}}}});
  const EnvironmentMap map = read_environment(dir / "a.exr", 1.0f, 0.0f);
  EXPECT_EQ(map.radiance.width, 2);
  EXPECT_THAT(map.radiance.data, ElementsAre(0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 0));
}

TEST(EnvironmentFile, grey_beside_other_channels_is_grey) {
  const TempDir dir;
  write_panorama(dir / "a.exr", {{}, {}, {{"Y", {2}}, {"Z", {9}}, {"id", {7}}}});
  EXPECT_THAT(read_environment(dir / "a.exr", 1.0f, 0.0f).radiance.data, ElementsAre(2, 2, 2));
}

TEST(EnvironmentFile, channels_left_out_are_named) {
  const TempDir dir;
  write_panorama(dir / "a.exr", {{}, {}, {{"A", {1}}, {"B", {1}}, {"G", {1}}, {"N.X", {1}}, {"R", {1}}, {"Z", {9}}}});
  Context context;
  std::vector<std::string> warnings;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  read_environment(dir / "a.exr", 1.0f, 0.0f, context);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.exr: only its colours are read, not 'alpha, Z, N.X'")));
}

TEST(EnvironmentFile, hdr_exposure_is_undone_pixel_aspect_warns) {
  const TempDir dir;
  std::ofstream(dir / "a.hdr", std::ios::binary)
      << "#?RADIANCE\nEXPOSURE=4\nPIXASPECT=2\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x83";
  Context context;
  std::vector<std::string> warnings;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  EXPECT_THAT(read_environment(dir / "a.hdr", 1.0f, 0.0f, context).radiance.data, ElementsAre(1, 1, 1));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.hdr: its pixels are 0.5 times as wide as high")));
}

TEST(EnvironmentFile, files_without_colours_are_refused) {
  const TempDir dir;
  write_panorama(dir / "a.exr", {{}, {}, {{"u", {1}}, {"v", {2}}}});
  EXPECT_THAT(test::error_message([&] { read_environment(dir / "a.exr", 1.0f, 0.0f); }),
              HasSubstr("a.exr: none of its channels is a colour: 'u, v'"));
  write_panorama(dir / "a.exr", {{}, {}, {{"Z", {1}}}});
  EXPECT_THAT(test::error_message([&] { read_environment(dir / "a.exr", 1.0f, 0.0f); }),
              HasSubstr("a.exr: its only channel 'Z' is not a colour"));
  write_panorama(dir / "a.exr", {{}, {}, {{"G", {1}}, {"R", {2}}}});
  EXPECT_THAT(test::error_message([&] { read_environment(dir / "a.exr", 1.0f, 0.0f); }),
              HasSubstr("a.exr: it has no channel B beside its channels 'R, G'"));
  write_panorama(dir / "a.exr", {{}, {}, {{"X", {1}}, {"Y", {2}}, {"Z", {3}}}});
  EXPECT_THAT(test::error_message([&] { read_environment(dir / "a.exr", 1.0f, 0.0f); }),
              HasSubstr("Y beside X is a coordinate, not luminance"));
}

// The file's samples are truncated, so decoding them would give another error.
TEST(EnvironmentFile, integer_pictures_are_refused_before_decoding) {
  const TempDir dir;
  write_picture(dir / "a.png", Image8{64, 64, std::vector<unsigned char>(3 * 64 * 64, 100)});
  std::filesystem::resize_file(dir / "a.png", std::filesystem::file_size(dir / "a.png") / 2);
  EXPECT_THAT(test::error_message([&] { read_environment(dir / "a.png", 1.0f, 0.0f); }), HasSubstr("not linear light"));
}

}  // namespace
}  // namespace lippmann
