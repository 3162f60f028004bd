#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

void render_teapot(const TempDir& dir) { rendered(dir, small_teapot("3-4", "out"), "out"); }

TEST(Replay, folder_of_frames_gives_one_eye_view_each_beside_them) {
  const TempDir dir;
  render_teapot(dir);
  const nlohmann::json report = report_of(dir, {"replay", "out"});
  EXPECT_EQ(report["out_of_zone"], 0.0);
  EXPECT_EQ(files_in(dir / "out/replay", ".png").size(), 2u);
  const Image8 picture = read_image8(dir / "out/replay/eye_0003.png"), panel = read_image8(dir / "out/frame_0003.png");
  EXPECT_EQ(picture.width, panel.width);
  EXPECT_EQ(picture.height, panel.height);
  EXPECT_NE(picture.rgb, panel.rgb);
}

TEST(Replay, two_eyes_give_left_right_and_both_side_by_side) {
  const TempDir dir;
  render_teapot(dir);
  const Files files = rendered(dir, {"replay", "out/frame_0003.png", "--ipd", "10", "-o", "eyes"}, "eyes");
  ASSERT_EQ(files.size(), 3u);
  EXPECT_NE(files.at("left_0003.png"), files.at("right_0003.png"));
  const Image8 left = read_image8(dir / "eyes/left_0003.png"), pair = read_image8(dir / "eyes/pair_0003.png");
  ASSERT_EQ(pair.width, 2 * left.width);
  for (int x = 0; x < 3 * left.width; ++x)
    ASSERT_EQ(pair.rgb[static_cast<std::size_t>(x)], left.rgb[static_cast<std::size_t>(x)]);
}

TEST(Replay, sweep_is_numbered_pictures_and_a_video) {
  const TempDir dir;
  render_teapot(dir);
  const Files files = rendered(dir, {"replay", "out", "--sweep", "5", "-o", "sweep", "--video", "sweep.mkv"}, "sweep");
  EXPECT_EQ(files.size(), 5u);
  EXPECT_NE(files.at("sweep_0000.png"), files.at("sweep_0004.png"));
  EXPECT_TRUE(fs::exists(dir / "sweep.mkv"));
}

TEST(Replay, refocusing_makes_what_is_asked_for_and_no_eye_view) {
  const TempDir dir;
  render_teapot(dir);
  const Words asked{"replay", "out/frame_0003.png", "--refocus", "-5", "--focal-stack", "-10:10:3", "--epi", "7", "-o", "a"};
  const Files files = rendered(dir, asked, "a");
  EXPECT_EQ(files.size(), 5u);
  for (const char* name : {"refocus_0003.png", "stack_0003_00.png", "stack_0003_02.png", "epi_row_0003.png"})
    EXPECT_TRUE(files.contains(name)) << name;
  rendered(dir, {"replay", "out/frame_0003.png", "--focal-stack", "-10:10:3", "--all-in-focus", "-o", "b"}, "b");
  EXPECT_EQ(channel_names(dir / "b/depth_0003.exr"), std::vector<std::string>{"Z"});
  EXPECT_TRUE(fs::exists(dir / "b/all_in_focus_0003.png"));
}

TEST(Replay, impossible_depths_and_lines_are_refused) {
  const TempDir dir;
  render_teapot(dir);
  for (const Words& flags : std::vector<Words>{{"--refocus", "1e6"},
                                               {"--refocus", "nan"},
                                               {"--focal-stack", "1:2"},
                                               {"--focal-stack", "1:2:1"},
                                               {"--focal-stack", "nan:2:5"},
                                               {"--all-in-focus"},
                                               {"--epi", "100000"},
                                               {"--epi-column", "3"}})
    expect_refusal(run_tool(dir, Words{"replay", "out"} + flags), 2, flags[0]);
  expect_refusal(run_tool(dir, {"replay", "out", "--refocus", "1", "--video", "a.mkv"}), 2, "--video");
}

TEST(Replay, rotated_elemental_images_come_back_to_the_bit_and_can_be_replayed) {
  const TempDir dir;
  render_teapot(dir);
  rendered(dir, {"convert", "out", "turned", "--rotate-elemental"}, "turned");
  const Files files = rendered(dir, {"convert", "turned", "back", "--rotate-elemental"}, "back");
  EXPECT_EQ(read_image8(dir / "back/frame_0003.png").rgb, read_image8(dir / "out/frame_0003.png").rgb);
  EXPECT_NE(read_image8(dir / "turned/frame_0003.png").rgb, read_image8(dir / "out/frame_0003.png").rgb);
  EXPECT_EQ(rendered(dir, {"replay", "turned", "-o", "eye"}, "eye").size(), 2u);
}

TEST(Replay, smart_conversion_makes_pictures_for_the_displays_own_lenses) {
  const TempDir dir;
  render_teapot(dir);
  rendered(dir, {"convert", "out", "smart", "--spoc", "8", "--lens-pixels", "12", "--gap", "3"}, "smart");
  const nlohmann::json optics = json_of(bytes_of(dir / "smart/report.json"))["optics"];
  EXPECT_EQ(optics["gap_mm"], 3.0);
  EXPECT_EQ(read_image8(dir / "smart/frame_0003.png").width, optics["width"]);
  EXPECT_EQ(rendered(dir, {"replay", "smart", "--eye", "0,0,4000", "-o", "eye"}, "eye").size(), 2u);
  expect_refusal(run_tool(dir, {"convert", "out", "a", "--spoc", "8", "--gap", "-1"}), 2, "--spoc");
  expect_refusal(run_tool(dir, {"convert", "out", "a", "--spoc", "nan"}), 2, "--spoc");
  expect_refusal(run_tool(dir, {"convert", "out", "a", "--spoc", "8", "--reference-plane", "-1"}), 2, "--reference-plane");
  expect_refusal(run_tool(dir, {"convert", "out", "out", "--rotate-elemental"}), 2, "another folder");
  expect_refusal(run_tool(dir, {"convert", "out", "a", "--rotate-elemental", "--spoc", "8"}), 2, "--spoc");
}

TEST(Replay, eye_out_of_the_zone_is_warned_of) {
  const TempDir dir;
  render_teapot(dir);
  const RunResult result = run_tool(dir, {"replay", "out", "--eye", "1000,0,300"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("out of the viewing zone of 100 %"), std::string::npos) << result.err;
}

TEST(Replay, impossible_eyes_and_sizes_are_refused) {
  const TempDir dir;
  render_teapot(dir);
  for (const char* eye : {"0,0,0", "0,0,-10", "0,0,nan", "inf,0,100"})
    expect_refusal(run_tool(dir, {"replay", "out", "--eye", eye}), 2, "--eye");
  expect_refusal(run_tool(dir, {"replay", "out", "--size", "12"}), 2, "--size");
  expect_refusal(run_tool(dir, {"replay", "out", "--size", "60000x60000"}), 2, "--size");
  expect_refusal(run_tool(dir, {"replay", "out", "--crosstalk", "-1"}), 2, "--crosstalk");
  expect_refusal(run_tool(dir, {"replay", "out", "--pupil", "nan"}), 2, "--pupil");
  EXPECT_FALSE(fs::exists(dir / "out/replay"));
}

TEST(Replay, folder_without_a_report_or_with_other_pictures_is_refused) {
  const TempDir dir;
  render_teapot(dir);
  expect_refusal(run_tool(dir, {"replay", "none"}), 1, "none");
  write_png(dir / "out/frame_0004.png", Image8{8, 8, std::vector<unsigned char>(192)});
  expect_refusal(run_tool(dir, {"replay", "out/frame_0004.png"}), 1, "has 8x8 pixels");
  for (const char* text : {"", "[", "[1, 2]", "{}", "{\"optics\": 3}", "{\"optics\": {\"kind\": \"lens\"}}"}) {
    std::ofstream(dir / "out/report.json") << text;
    expect_refusal(run_tool(dir, {"replay", "out"}), 1, "report.json");
  }
  fs::remove(dir / "out/report.json");
  expect_refusal(run_tool(dir, {"replay", "out"}), 1, "report.json");
  expect_refusal(run_tool(dir, {"replay", "."}), 1, "no frames");
}

TEST(Replay, views_are_not_taken_for_what_lies_behind_lenses) {
  const TempDir dir;
  render_teapot(dir);
  nlohmann::json report = json_of(bytes_of(dir / "out/report.json"));
  report["settings"]["layout"] = "quilt";
  std::ofstream(dir / "out/report.json") << report.dump();
  expect_refusal(run_tool(dir, {"replay", "out"}), 1, "'quilt'");
}

}  // namespace
}  // namespace lippmann::test
