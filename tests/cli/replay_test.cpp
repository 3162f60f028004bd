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
  expect_refusal(run_tool(dir, {"convert", "out", "out", "--rotate-elemental"}), 1, "another folder");
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

/// What one eye sees of a light field, as a PNG file's bytes; `said`: more words of the command.
std::string eye_view_of(const TempDir& dir, const std::string& in, const Words& said = {}) {
  fs::remove_all(dir / "eye");
  const Files files = rendered(dir, Words{"replay", in, "-o", "eye"} + said, "eye");
  return files.empty() ? std::string() : files.begin()->second;
}

TEST(Replay, every_layout_of_a_render_looks_the_same_to_an_eye) {
  const TempDir dir;
  for (const Words& optics : std::vector<Words>{{"--optics", "lenticular", "--lenses", "8"},
                                                {"--optics", "microlens", "--lenses", "16x12"},
                                                {"--optics", "multiview", "--views", "4x2"}}) {
    const Words render = Words{"render", "teapot", "--frames", "3", "--size", "64x48"} + optics;
    ASSERT_EQ(run_tool(dir, render + Words{"-o", "as-shown"}).exit_code, 0);
    const std::string eye = eye_view_of(dir, "as-shown");
    for (const char* layout : {"integral", "views", "quilt"}) {
      fs::remove_all(dir / "other");
      ASSERT_EQ(run_tool(dir, render + Words{"-o", "other", "--layout", layout}).exit_code, 0);
      EXPECT_TRUE(eye_view_of(dir, "other") == eye) << optics[1] << " " << layout;
    }
    fs::remove_all(dir / "as-shown");
  }
}

TEST(Replay, folders_that_state_their_cameras_look_as_what_they_were_made_of) {
  const TempDir dir;
  const Words grid{"--optics", "multiview", "--camera-grid", "--views", "3x3", "--size", "48x36"};
  ASSERT_EQ(run_tool(dir, Words{"render", "teapot", "--frames", "3", "-o", "out"} + grid).exit_code, 0);
  const std::string eye = eye_view_of(dir, "out", {"--ipd", "4"});
  for (const char* format : {"hci", "miv"}) {
    const std::string folder = std::string("elsewhere/") + format;
    ASSERT_EQ(run_tool(dir, {"convert", "out/frame_0003.png", folder, "--to", format}).exit_code, 0);
    EXPECT_TRUE(eye_view_of(dir, folder, {"--ipd", "4"}) == eye) << format;
  }
}

TEST(Replay, cameras_that_nothing_states_are_assumed_and_the_tool_says_so) {
  const TempDir dir;
  const Words grid{"--optics", "multiview", "--camera-grid", "--views", "3x3", "--size", "48x36"};
  ASSERT_EQ(run_tool(dir, Words{"render", "teapot", "--frames", "3", "-o", "out"} + grid).exit_code, 0);
  for (const char* format : {"stanford", "jpeg-pleno"}) {
    ASSERT_EQ(run_tool(dir, {"convert", "out/frame_0003.png", format, "--to", format}).exit_code, 0);
    const RunResult result = run_tool(dir, {"replay", format});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("Nothing says where the cameras of"), std::string::npos) << result.err;
    EXPECT_TRUE(fs::exists(dir / format / "replay" / (std::string("eye_") + format + ".png")));
    for (const Words& product : std::vector<Words>{{"--refocus", "-5"}, {"--epi", "3"}, {"--epi-column", "3"}})
      EXPECT_EQ(run_tool(dir, Words{"replay", format} + product).exit_code, 0) << product[0];
  }
}

TEST(Replay, quilt_is_known_by_its_name_and_other_pictures_by_flags) {
  const TempDir dir;
  render_teapot(dir);
  fs::create_directories(dir / "a");
  ASSERT_EQ(run_tool(dir, {"convert", "out/frame_0003.png", "a/picture.png", "--to", "quilt", "--aspect", "0.75"}).exit_code,
            0);
  const std::string quilt = "a/picture_qs4x2a0.75.png";
  ASSERT_TRUE(fs::exists(dir / quilt));
  const std::string eye = eye_view_of(dir, quilt);
  EXPECT_TRUE(fs::exists(dir / "eye/eye_picture.png"));
  const Image8 picture = read_image8(dir / "eye/eye_picture.png");
  EXPECT_NEAR(static_cast<double>(picture.width) / picture.height, 0.75, 0.02);
  fs::rename(dir / quilt, dir / "a/plain.png");
  expect_refusal(run_tool(dir, {"replay", "a/plain.png"}), 1, "nothing says what this picture is");
  EXPECT_FALSE(eye_view_of(dir, "a/plain.png", {"--from", "quilt", "--quilt", "4x2"}).empty());
  expect_refusal(run_tool(dir, {"replay", "out", "--view-angle", "20"}), 2, "--view-angle");
}

TEST(Replay, eye_is_told_only_where_a_picture_shows_what_one_sees) {
  const TempDir dir;
  render_teapot(dir);
  EXPECT_NE(run_tool(dir, {"replay", "out"}).out.find("eye at"), std::string::npos);
  EXPECT_EQ(run_tool(dir, {"replay", "out", "--refocus", "-5"}).out.find("eye"), std::string::npos);
  EXPECT_TRUE(report_of(dir, {"replay", "out", "--epi", "3"})["eye_mm"].is_null());
}

TEST(Replay, warning_beyond_a_camera_grid_speaks_of_cameras_and_not_of_lenses) {
  const TempDir dir;
  const Words grid{"--optics", "multiview", "--camera-grid", "--views", "3x3", "--size", "48x36"};
  ASSERT_EQ(run_tool(dir, Words{"render", "teapot", "--frames", "3", "-o", "out"} + grid).exit_code, 0);
  const RunResult result = run_tool(dir, {"replay", "out", "--eye", "5000,0,300"});
  EXPECT_NE(result.err.find("the outermost cameras' pictures"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("lens"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace lippmann::test
