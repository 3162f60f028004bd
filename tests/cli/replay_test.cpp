#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void render_for_replay(const TempDir& dir) { expect_done(dir, small_teapot("3-4", "out")); }

TEST(Replay, flags_select_the_pictures) {
  const TempDir dir;
  render_for_replay(dir);
  EXPECT_THAT(run_tool(dir, {"replay", "out"}).out, HasSubstr("eye at"));
  EXPECT_EQ(files_in(dir / "out/replay", ".png").size(), 2u);
  EXPECT_THAT(run_tool(dir, {"replay", "out", "--refocus", "-5"}).out, testing::Not(HasSubstr("eye")));
  EXPECT_TRUE(report_of(dir, {"replay", "out", "--epi", "3"})["eye_mm"].is_null());
  const Words products{"--refocus", "-5", "--focal-stack", "-10:10:3", "--epi", "7", "-o", "a"};
  EXPECT_EQ(rendered(dir, Words{"replay", "out/frame_0003.png"} + products, "a").size(), 5u);
  const Words eyes{"--ipd", "10", "-o", "eyes"}, sweep{"--sweep", "5", "-o", "sweep", "--video", "sweep.mkv"};
  EXPECT_EQ(rendered(dir, Words{"replay", "out/frame_0003.png"} + eyes, "eyes").size(), 3u);
  EXPECT_EQ(rendered(dir, Words{"replay", "out"} + sweep, "sweep").size(), 5u);
  EXPECT_TRUE(fs::exists(dir / "sweep.mkv"));
}

TEST(Replay, warnings_go_to_stderr) {
  const TempDir dir;
  render_for_replay(dir);
  const RunResult result = run_tool(dir, {"replay", "out", "--eye", "1000,0,300"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("For 100 % of the display, the eye"));
}

TEST(Replay, impossible_values_name_their_flag) {
  const TempDir dir;
  render_for_replay(dir);
  for (const Words& flags : std::vector<Words>{{"--refocus", "1e6"},
                                               {"--refocus", "nan"},
                                               {"--focal-stack", "1:2"},
                                               {"--focal-stack", "1:2:1"},
                                               {"--focal-stack", "nan:2:5"},
                                               {"--all-in-focus"},
                                               {"--epi", "100000"},
                                               {"--epi-column", "3"},
                                               {"--eye", "0,0,-10"},
                                               {"--eye", "inf,0,100"},
                                               {"--size", "12"},
                                               {"--size", "60000x60000"},
                                               {"--crosstalk", "-1"},
                                               {"--pupil", "nan"},
                                               {"--video", "a.mkv", "--refocus", "1"},
                                               {"--view-angle", "20"}})
    expect_refusal(run_tool(dir, Words{"replay", "out"} + flags), 2, flags[0]);
  EXPECT_FALSE(fs::exists(dir / "out/replay"));
  expect_refusal(run_tool(dir, {"replay", "none"}), 1, "none");
}

TEST(Replay, flags_without_effect_are_refused) {
  const TempDir dir;
  render_for_replay(dir);
  for (const Words& flags : std::vector<Words>{{"--eye", "0,0,300", "--refocus", "1"},
                                               {"--pupil", "4", "--epi", "3"},
                                               {"--focus", "4"},
                                               {"--filter", "nearest", "--refocus", "1"},
                                               {"--size", "40x40", "--epi", "3"},
                                               {"--crosstalk", "0.3", "--focal-stack", "1:-1:3"},
                                               {"--fps", "12"},
                                               {"--views", "8x1"},
                                               {"--quilt", "8x1"},
                                               {"--display", "portrait"}})
    expect_refusal(run_tool(dir, Words{"replay", "out"} + flags), 2, flags[0] + ": has no effect");
}

TEST(Replay, foreign_panel_frame_needs_its_display) {
  const TempDir dir;
  std::ofstream(dir / "d.toml") << "kind = \"slanted-panel\"\npixels = [40, 30]\ndpi = 60\nview_cone_deg = 40\n"
                                   "[calibration]\npitch = 8.1\nslope = -5\ncenter = 0.3\n";
  expect_done(dir, {"render", "room", "--display", "d.toml", "--layout", "native", "--frames", "0", "-o", "n"});
  expect_done(dir, {"replay", "n", "-o", "own"});
  fs::create_directories(dir / "f");
  fs::copy(dir / "n/frame_0000.png", dir / "f/foreign.png");
  expect_done(dir, {"replay", "f/foreign.png", "--display", "d.toml", "-o", "a"});
  expect_done(dir, {"replay", "f/foreign.png", "--from", "native", "--display", "d.toml", "-o", "b"});
  EXPECT_EQ(bytes_of(dir / "a/eye_foreign.png"), bytes_of(dir / "own/eye_0000.png"));
  EXPECT_EQ(bytes_of(dir / "b/eye_foreign.png"), bytes_of(dir / "own/eye_0000.png"));
  expect_refusal(run_tool(dir, {"replay", "f/foreign.png", "--display", "portrait"}), 1, "40x30 pixels");
  expect_refusal(run_tool(dir, {"replay", "f/foreign.png", "--from", "native"}), 2, "--display");
  expect_done(dir, {"view", "f/foreign.png", "--display", "d.toml", "--save", "page"});
}

TEST(Replay, foreign_quilt_is_seen_through_its_display) {
  const TempDir dir;
  std::ofstream(dir / "d.toml") << "base = \"portrait\"\n[quilt]\ntiles = [4, 2]\nsize = [96, 64]\naspect = 0.75\n";
  expect_done(dir, {"render", "room", "--display", "d.toml", "--frames", "0", "-o", "q"});
  expect_done(dir, {"replay", "q", "--eye", "60,0,650", "--size", "60x80", "-o", "own"});
  fs::create_directories(dir / "f");
  fs::copy(dir / "q/frame_0000_qs4x2a0.75.png", dir / "f/other_QS4X2A0.75 (1).png");
  const Words replay{"replay", "f", "--eye", "60,0,650", "--size", "60x80", "--display", "d.toml"};
  expect_done(dir, replay + Words{"-o", "a"});
  EXPECT_EQ(bytes_of(dir / "a/eye_other (1).png"), bytes_of(dir / "own/eye_0000.png"));
  expect_done(dir, replay + Words{"--cone-ends", "-o", "b"});
  EXPECT_NE(bytes_of(dir / "b/eye_other (1).png"), bytes_of(dir / "own/eye_0000.png"));
}

TEST(Replay, assumed_cameras_are_reported) {
  const TempDir dir;
  render_for_replay(dir);
  expect_done(dir, {"convert", "out/frame_0003.png", "f/q.png", "--to", "quilt"});
  EXPECT_THAT(run_tool(dir, {"replay", "f/q_qs4x2a1.png"}).err,
              HasSubstr("8 views 5 degrees apart, the outermost half a step"));
  EXPECT_THAT(run_tool(dir, {"replay", "f/q_qs4x2a1.png", "--cone-ends", "--view-angle", "35"}).err,
              HasSubstr("8 views 5 degrees apart, the outermost at the ends of 35 degrees"));
}

TEST(Info, describes_pictures_and_folders) {
  const TempDir dir;
  render_for_replay(dir);
  nlohmann::json info = report_of(dir, {"info", "out"});
  EXPECT_EQ(info["format"], "integral");
  EXPECT_EQ(info["views"], nlohmann::json({8, 1}));
  EXPECT_EQ(info["side_file"], "out/report.json");
  expect_done(dir, {"convert", "out/frame_0003.png", "q.png", "--to", "quilt"});
  info = report_of(dir, {"info", "q_qs4x2a1.png"});
  EXPECT_EQ(info["format"], "quilt");
  EXPECT_EQ(info["side_file"], "q_qs4x2a1.png.json");
  EXPECT_EQ(info["cameras"], nullptr);
  expect_done(dir, {"render", "teapot", "--cameras", "sphere:3", "--size", "32x24", "-q", "-o", "turned"});
  info = report_of(dir, {"info", "turned"});
  EXPECT_EQ(info["cameras"], "poses, each camera turned by itself");
  EXPECT_EQ(info["side_file"], "turned/transforms.json");
  fs::copy(dir / "out/frame_0003.png", dir / "plain.png");
  info = report_of(dir, {"info", "plain.png"});
  EXPECT_EQ(info["format"], nullptr);
  EXPECT_THAT(info["problem"].get<std::string>(), testing::HasSubstr("is unknown"));
  expect_refusal(run_tool(dir, {"info", "plain.png", "--zoom", "2"}), 2, "--zoom: has no effect on pictures");
  expect_refusal(run_tool(dir, {"info", "none.png"}), 1, "none.png: there is no such file");
}

/// lf.h5 has the colours and cameras of the first file of tests/layout/hci_hdf5_test.cpp, and a depth of 7 m.
TEST(Info, light_field_files_are_described_and_shown) {
  if (!fs::exists(fs::path(LIPPMANN_TOOL).parent_path() / "liblippmann_hdf5.so")) GTEST_SKIP() << "libhdf5-dev is missing";
  const TempDir dir;
  fs::copy_file(LIPPMANN_SOURCE "/tests/formats/files/lf.h5", dir / "lf.h5");
  const nlohmann::json info = report_of(dir, {"info", "lf.h5"});
  EXPECT_EQ(info["format"], "hci-hdf5");
  EXPECT_EQ(info["views"], nlohmann::json({3, 2}));
  EXPECT_EQ(info["cameras"], "20 mm apart, 7000 mm from the display");
  expect_done(dir, {"replay", "lf.h5", "--refocus", "0", "-o", "r"});
  EXPECT_TRUE(fs::exists(dir / "r/refocus_lf.png"));
  expect_done(dir, {"view", "lf.h5", "--save", "page.html"});
  EXPECT_TRUE(fs::exists(dir / "page.html"));
  std::ofstream(dir / "other.txt") << "no light field";
  expect_refusal(run_tool(dir, {"view", "other.txt", "--save", "page2.html"}), 1, "other.txt: is not a picture");
}

TEST(Replay, flags_describe_unknown_pictures) {
  const TempDir dir;
  render_for_replay(dir);
  fs::create_directories(dir / "a");
  expect_done(dir, {"convert", "out/frame_0003.png", "a/picture.png", "--to", "quilt"});
  fs::rename(dir / "a/picture_qs4x2a1.png", dir / "a/plain.png");
  expect_refusal(run_tool(dir, {"replay", "a/plain.png"}), 2, "the format of a/plain.png is unknown");
  expect_done(dir, {"replay", "a/plain.png", "--from", "quilt", "--quilt", "4x2"});
}

}  // namespace
}  // namespace lippmann::test
