// render --to FORMAT: light fields in the formats of convert, without a second command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Words kGrid{"render", "teapot", "--optics", "multiview", "--camera-grid", "--views", "2x2",
                  "--size", "32x32",  "--frames", "0-1"};

Files files_below(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (const std::string name = entry.path().lexically_relative(folder); entry.is_regular_file() && name.starts_with("frame_"))
      files[name] = bytes_of(entry.path());
  return files;
}

TEST(RenderTo, writes_the_files_that_convert_makes_of_the_same_render_and_check_knows_them) {
  const TempDir dir;
  expect_done(dir, kGrid + Words{"--aov", "depth", "-o", "film"});
  for (const std::string format : {"hci", "stanford", "jpeg-pleno", "miv", "eslf", "views", "integral", "quilt"}) {
    expect_done(dir, {"convert", "film", "converted-" + format, "--to", format});
    expect_done(dir, kGrid + Words{"--to", format, "-o", format});
    const Files converted = files_below(dir / ("converted-" + format));
    EXPECT_FALSE(converted.empty());
    EXPECT_EQ(files_below(dir / format), converted) << format;
    expect_done(dir, {"check", format});
    expect_done(dir, {"replay", format, "--from", format, "--views", "2x2", "-o", "eye-" + format});
  }
}

TEST(RenderTo, keeps_light_and_16_bits_where_the_pictures_are_to) {
  const TempDir dir;
  for (const std::string format : {"exr", "png16"}) {
    expect_done(dir, kGrid + Words{"--aov", "depth", "--format", format, "--layout", "views", "-o", "film-" + format});
    expect_done(dir, {"convert", "film-" + format, "converted-" + format, "--to", "hci"});
    expect_done(dir, kGrid + Words{"--to", "hci", "--format", format, "-o", format});
    const Files made = files_below(dir / format), converted = files_below(dir / ("converted-" + format));
    if (format == "exr")  // the view's own EXR holds halves
      EXPECT_TRUE(made.contains("frame_0001/input_Cam003.exr"));
    else
      EXPECT_EQ(made, converted);
  }
}

TEST(RenderTo, damaged_and_missing_files_are_made_again_by_resume) {
  const TempDir dir;
  const Words command = kGrid + Words{"--to", "hci", "-o", "a"};
  expect_done(dir, command);
  const Files whole = files_below(dir / "a");
  fs::remove(dir / "a/frame_0001/parameters.cfg");
  std::ofstream(dir / "a/frame_0000/gt_disp_lowres_Cam001.pfm") << "damaged";
  const RunResult check = run_tool(dir, {"check", "a"});
  EXPECT_THAT(check.out, HasSubstr("damaged  frame_0000/gt_disp_lowres_Cam001.pfm"));
  EXPECT_THAT(check.out, HasSubstr("missing  frame_0001/parameters.cfg"));
  expect_done(dir, command + Words{"--resume"});
  EXPECT_EQ(files_below(dir / "a"), whole);
  expect_done(dir, {"render", "a/job.toml", "--resume"});
}

TEST(RenderTo, what_a_format_does_not_hold_is_refused_before_anything_is_rendered) {
  const TempDir dir;
  const auto refused = [&](const Words& flags, int code, const std::string& message) {
    expect_refusal(run_tool(dir, kGrid + Words{"-o", "a"} + flags), code, message);
    EXPECT_FALSE(fs::exists(dir / "a"));
  };
  refused({"--to", "hcl"}, 2, "did you mean 'hci'?");
  refused({"--to", "hci", "--layout", "quilt"}, 2, "--to: 'hci' is not what --layout asks for");
  refused({"--to", "hci", "--aov", "normal"}, 2, "--aov: files of the format hci have no such layer");
  refused({"--to", "jpeg-pleno", "--aov", "depth"}, 2, "--aov");
  refused({"--to", "hci", "--transparent"}, 2, "--transparent: files of the format hci hold no alpha");
  refused({"--to", "hci", "--video", "a.mp4"}, 2, "--video: views are pictures of their own");
  refused({"--to", "hci", "--format", "tiff"}, 2, "--format: light fields hold no TIFF pictures");
  const Words slanted{"render", "teapot", "--lens-pixels", "7.5", "--frames", "0", "-o", "a", "--to", "views"};
  EXPECT_EQ(run_tool(dir, slanted).exit_code, 2);
}

}  // namespace
}  // namespace lippmann::test
