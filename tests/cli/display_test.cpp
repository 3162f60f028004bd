// `render --display`: size, optics and layout come from the display.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

/// A small slanted panel, and a sheet on a print of 2 x 1 inches.
void write_displays(const TempDir& dir) {
  std::ofstream(dir / "panel.toml") << R"(description = "small"
kind = "slanted-panel"
pixels = [48, 64]
dpi = 324
view_cone_deg = 40
[calibration]
pitch = 52.0
slope = -7.0
center = 0.5
[quilt]
tiles = [4, 2]
size = [129, 128]
aspect = 0.75
)";
  std::ofstream(dir / "sheet.toml") << R"(description = "print"
kind = "lenticular-sheet"
pixels = [240, 120]
dpi = 120
view_cone_deg = 40
[lenses]
lenses_per_inch = 20
)";
}

Words teapot_on(const std::string& display, const Words& more, const std::string& folder = "out") {
  return Words{"render", "teapot", "--frames", "3", "--display", display, "-o", folder} + more;
}

std::vector<std::string> names(const Files& files) {
  std::vector<std::string> all;
  for (const auto& [name, bytes] : files) all.push_back(name);
  return all;
}

TEST(Display, slanted_panel_is_shown_a_quilt_of_its_tiles_size_and_cone) {
  const TempDir dir;
  write_displays(dir);
  const auto report = report_of(dir, teapot_on("panel.toml", {}));
  EXPECT_THAT(names(files_in(dir / "out", ".png")), testing::ElementsAre("frame_0003_qs4x2a0.75.png"));
  EXPECT_EQ(report["optics"]["kind"], "multiview");
  EXPECT_EQ(report["optics"]["width"], 129);
  EXPECT_NEAR(report["optics"]["view_cone_deg"].get<double>(), 40.0, 1e-4);
  // A tile of 32 x 64 pixels on a display of 48 x 64: its pixels are 1.5 display pixels wide, 1 high.
  EXPECT_NEAR(report["optics"]["pixel_height"].get<double>(), 2.0 / 3.0, 1e-6);
}

TEST(Display, native_frame_has_the_panel_s_pixels) {
  const TempDir dir;
  write_displays(dir);
  const auto report = report_of(dir, teapot_on("panel.toml", {"--layout", "native", "--video", "a.mkv"}));
  EXPECT_EQ(report["optics"]["kind"], "slanted");
  EXPECT_EQ(report["optics"]["width"], 3 * 48);
  const RunResult compared = run_tool(dir, {"compare", "out", "a.mkv", "--json"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;  // 48 x 64, both
  EXPECT_TRUE(json_of(compared.out)["identical"]);
}

TEST(Display, print_is_a_tiff_at_the_sheet_s_resolution_and_may_be_mirrored) {
  const TempDir dir;
  write_displays(dir);
  ASSERT_EQ(run_tool(dir, teapot_on("sheet.toml", {"--layout", "print"})).exit_code, 0);
  const std::string tiff = bytes_of(dir / "out/frame_0003.tif");
  // XResolution, tag 282 = 0x011a, type 5, one value; the rational it points to is 120 / 1.
  const std::string tag("\x1a\x01\x05\x00\x01\x00\x00\x00", 8);
  const std::size_t at = tiff.find(tag);
  ASSERT_NE(at, std::string::npos);
  const auto word = [&](std::size_t i) {
    std::uint32_t value = 0;
    for (std::size_t b = 0; b < 4; ++b) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(tiff[i + b])) << (8 * b);
    return value;
  };
  const std::uint32_t rational = word(at + 8);
  EXPECT_EQ(word(rational), 120u * word(rational + 4));

  ASSERT_EQ(run_tool(dir, teapot_on("sheet.toml", {"--layout", "print", "--mirror"}, "mirror")).exit_code, 0);
  ASSERT_EQ(run_tool(dir, teapot_on("sheet.toml", {}, "plain")).exit_code, 0);
  EXPECT_FALSE(json_of(run_tool(dir, {"compare", "plain/frame_0003.png", "mirror/frame_0003.tif", "--json"}).out)["identical"]);
  EXPECT_TRUE(json_of(run_tool(dir, {"compare", "plain/frame_0003.png", "out/frame_0003.tif", "--json"}).out)["identical"]);
}

TEST(Display, test_pattern_is_one_quilt_without_layers) {
  const TempDir dir;
  write_displays(dir);
  ASSERT_EQ(run_tool(dir, {"render", "test-pattern", "--display", "panel.toml", "-o", "out"}).exit_code, 0);
  EXPECT_EQ(names(files_in(dir / "out", ".png")).size(), 1u);
  expect_refusal(run_tool(dir, {"render", "test-pattern", "--aov", "depth"}), 2, "no extra layers");
}

TEST(Display, also_single_renders_the_middle_view_beside_the_pictures) {
  const TempDir dir;
  write_displays(dir);
  const RunResult result = run_tool(dir, teapot_on("panel.toml", {"--also", "single", "--video", "a.mkv"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(dir / "a_qs4x2a0.75.mkv"));
  EXPECT_TRUE(std::filesystem::exists(dir / "a_single.mkv"));
  ASSERT_EQ(run_tool(dir, {"render", "teapot", "--frames", "3", "--display", "panel.toml", "--optics", "single", "-o", "one"})
                .exit_code,
            0);
  EXPECT_EQ(files_in(dir / "out/single", ".png"), files_in(dir / "one", ".png"));
}

TEST(Display, what_it_does_not_play_is_warned_of) {
  const TempDir dir;
  write_displays(dir);
  std::ofstream(dir / "panel.toml", std::ios::app) << "[video]\ncodec = \"h264\"\nlongest_side = 100\nquilts = false\n";
  const RunResult result = run_tool(dir, teapot_on("panel.toml", {"--video", "a.mkv"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("pictures of quilts only"));
  EXPECT_THAT(result.err, HasSubstr("up to 100 pixels a side"));
}

TEST(Display, job_and_resume_know_the_display) {
  const TempDir dir;
  write_displays(dir);
  ASSERT_EQ(run_tool(dir, teapot_on("panel.toml", {})).exit_code, 0);
  EXPECT_THAT(run_tool(dir, {"render", "out/job.toml", "--resume"}).out, HasSubstr("1 kept from before"));
  std::ofstream(dir / "panel.toml", std::ios::app) << "[video]\ncodec = \"h264\"\nlongest_side = 4096\nquilts = true\n";
  EXPECT_THAT(run_tool(dir, {"render", "out/job.toml", "--resume"}).out, Not(HasSubstr("kept")));
}

TEST(Display, what_it_does_not_have_is_refused) {
  const TempDir dir;
  write_displays(dir);
  const auto refused = [&](const std::string& display, const Words& words, const std::string& message) {
    expect_refusal(run_tool(dir, teapot_on(display, words)), 2, message);
  };
  refused("portait", {}, "did you mean 'portrait'?");
  refused("panel.toml", {"--lenses", "20"}, "--lenses");
  refused("panel.toml", {"--layout", "native", "--size", "99x99"}, "a calibrated panel has its own");
  refused("sheet.toml", {"--optics", "multiview"}, "knows no quilt");
  refused("panel.toml", {"--optics", "microlens"}, "is a slanted-panel");
  refused("sheet.toml", {"--mirror"}, "--layout print");
  expect_refusal(run_tool(dir, {"render", "teapot", "--layout", "native"}), 2, "--display");
}

// Nine pixels below a lens: an eye in the middle sees the middle of the fifth.
TEST(Display, precompensated_picture_looks_through_crosstalk_like_the_plain_one_without) {
  const TempDir dir;
  const Words render{"render", "teapot", "--frames", "3", "--lenses", "24", "--lens-pixels", "9", "--format", "exr"};
  run_tool(dir, render + Words{"-o", "plain"});
  const auto report = report_of(dir, render + Words{"-o", "shown", "--precompensate", "--crosstalk", "8%"});
  const auto& bound = report["precompensation"];
  EXPECT_NEAR(bound["neighbour_share"].get<double>(), 0.08, 1e-6);
  EXPECT_EQ(report["frames"][0]["precompensation"]["clipped_share"], bound["clipped_share"]);
  const auto seen = [&](const std::string& folder, const std::string& name, const Words& more) {
    run_tool(dir, Words{"replay", folder, "-o", name, "--size", "lenses"} + more);
    return name + "/eye_0003.png";
  };
  const std::string wanted = seen("plain", "a", {}), leaking = seen("plain", "b", {"--crosstalk", "8%"}),
                    undone = seen("shown", "c", {"--crosstalk", "8%"});
  const auto rmse = [&](const std::string& picture) {
    return report_of(dir, {"compare", wanted, picture})["mean"]["rmse"]["mean"].get<double>();
  };
  EXPECT_GE(rmse(leaking), 0.5);
  EXPECT_LE(rmse(undone), 0.5 * rmse(leaking));  // what had to be clipped is left
}

TEST(Display, crosstalk_of_the_display_is_in_its_own_pixels_and_a_quilt_s_in_views) {
  const TempDir dir;
  std::ofstream(dir / "leaky.toml") << R"(kind = "slanted-panel"
pixels = [48, 64]
dpi = 324
view_cone_deg = 40
crosstalk = 0.2
[calibration]
pitch = 52.0
slope = -7.0
center = 0.5
[quilt]
tiles = [4, 2]
size = [128, 128]
)";
  const auto quilt = report_of(dir, teapot_on("leaky.toml", {"--precompensate"}));
  // 8 views, and 324 / 52 = 6.23 pixels below a lens across it, 6.29 along a row.
  EXPECT_NEAR(quilt["precompensation"]["crosstalk_px"].get<double>(), 0.2 * 8 / (324 / 52.0 / std::cos(std::atan(1 / 7.0))),
              1e-6);
  const auto native = report_of(dir, teapot_on("leaky.toml", {"--precompensate", "--layout", "native"}, "native"));
  EXPECT_EQ(native["precompensation"]["crosstalk_px"], 0.2);
}

TEST(Display, finished_pictures_are_precompensated_to_the_same_codes) {
  const TempDir dir;
  const Words render{"render", "teapot", "--frames", "3", "--lenses", "24", "--format", "png16"};
  run_tool(dir, render + Words{"-o", "plain"});
  run_tool(dir, render + Words{"-o", "shown", "--precompensate", "--crosstalk", "0.35"});
  report_of(dir, {"convert", "plain", "made", "--precompensate", "--crosstalk", "0.35"});
  // The one from codes of 16 bits, the other from floats.
  const auto difference = report_of(dir, {"compare", "shown/frame_0003.png", "made/frame_0003.png"});
  EXPECT_LE(difference["mean"]["rmse"]["mean"].get<double>(), 0.05);
  EXPECT_EQ(run_tool(dir, {"replay", "made"}).exit_code, 0);
}

TEST(Display, crosstalk_that_nobody_says_or_wants_is_refused) {
  const TempDir dir;
  const Words render{"render", "teapot", "-o", "out"};
  expect_refusal(run_tool(dir, render + Words{"--precompensate"}), 2, "nothing says");
  expect_refusal(run_tool(dir, render + Words{"--crosstalk", "0.3"}), 2, "--precompensate");
  expect_refusal(run_tool(dir, render + Words{"--precompensate", "--crosstalk", "2"}), 2, "cannot be told apart");
  expect_refusal(run_tool(dir, render + Words{"--precompensate", "--crosstalk", "0.3", "--optics", "single"}), 2,
                 "single view");
  expect_refusal(run_tool(dir, {"convert", "out", "x", "--crosstalk", "0.3"}), 2, "--precompensate");
}

}  // namespace
}  // namespace lippmann::test
