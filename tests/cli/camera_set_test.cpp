#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kNoSharedPlane = "do not share a plane and a window";

Words render_set(const std::string& folder, const std::string& to) {
  return {"render", "teapot", "--cameras", "circle:3", "--size", "48x36", "--spp", "1", "--to", to, "-q", "-o", folder};
}

class CameraSets : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const char* to : {"nerf", "colmap", "llff"}) expect_done(made(), render_set(to, to));
  }

  void SetUp() override {
    for (const char* to : {"nerf", "colmap", "llff"}) fs::copy(made() / to, dir_ / to, fs::copy_options::recursive);
  }

  static const TempDir& made() {
    static const TempDir dir;
    return dir;
  }

  TempDir dir_;
};

TEST_F(CameraSets, encode_makes_a_video_of_the_cameras_in_order) {
  for (const std::string to : {"nerf", "colmap", "llff"}) {
    EXPECT_EQ(report_of(dir_, {"encode", to, to + ".mkv"})["frames"], 3) << to;
    expect_done(dir_, {"encode", to + "/images/%03d.png", to + "2.mkv"});
    EXPECT_EQ(bytes_of(dir_ / (to + ".mkv")), bytes_of(dir_ / (to + "2.mkv"))) << to;
  }
  EXPECT_EQ(report_of(dir_, {"encode", "nerf", "two.mkv", "--frames", "0,2"})["frames"], 2);
  expect_refusal(run_tool(dir_, {"encode", "nerf", "four.mkv", "--frames", "3"}), 1, "frame 3 is missing");
  fs::remove(dir_ / "nerf/images/002.png");
  expect_refusal(run_tool(dir_, {"encode", "nerf", "part.mkv"}), 1, "nerf/images/002.png: is missing");
}

TEST_F(CameraSets, compare_compares_the_pictures) {
  const nlohmann::json same = report_of(dir_, {"compare", "nerf", "colmap"});
  EXPECT_EQ(same["frames"].size(), 3u);
  EXPECT_TRUE(same["identical"]);
  fs::remove_all(dir_ / "llff/.lippmann");  // without the journal, another picture is not reported as damage
  fs::copy_file(dir_ / "llff/images/000.png", dir_ / "llff/images/001.png", fs::copy_options::overwrite_existing);
  EXPECT_FALSE(report_of(dir_, {"compare", "nerf", "llff"})["identical"]);
}

TEST_F(CameraSets, convert_keeps_poses_or_says_that_it_does_not) {
  for (const char* to : {"colmap", "llff", "miv", "cvkit"})
    EXPECT_THAT(run_tool(dir_, {"convert", "nerf", std::string("as-") + to, "--to", to}).err, Not(HasSubstr(kNoSharedPlane)));
  EXPECT_THAT(run_tool(dir_, {"convert", "colmap", "no-depth", "--to", "llff"}).err, Not(HasSubstr("depth")));
  for (const char* to : {"hci", "views", "quilt", "jpeg-pleno"}) {
    const RunResult result = run_tool(dir_, {"convert", "nerf", std::string("as-") + to, "--to", to});
    EXPECT_EQ(result.exit_code, 0) << to;
    EXPECT_THAT(result.err,
                HasSubstr(std::string("not written, because ") + to +
                          " cannot store them: the poses of 3 cameras, which do not share a plane and a window; the depth of 3 "
                          "views; the split into training and test views"));
  }
  EXPECT_THAT(run_tool(dir_, {"convert", "nerf", "portrait.png", "--display", "portrait"}).err,
              HasSubstr("cannot store them: the poses of 3 cameras, which do not share a plane and a window"));
  expect_refusal(run_tool(dir_, {"convert", "nerf", "as-rgbd", "--to", "rgbd"}), 2, kNoSharedPlane);
}

TEST_F(CameraSets, convert_keeps_the_split_and_names_lost_data) {
  for (const char* from : {"nerf", "colmap", "llff"})
    for (const char* to : {"nerf", "colmap", "llff"}) {
      const std::string out = std::string(from) + "-as-" + to;
      EXPECT_THAT(run_tool(dir_, {"convert", from, out, "--to", to}).err, Not(HasSubstr("split"))) << out;
      const char* file = to == std::string("nerf")     ? "transforms_test.json"
                         : to == std::string("colmap") ? "sparse/0/test.txt"
                                                       : "test.txt";
      EXPECT_THAT(bytes_of(dir_ / out / file), HasSubstr(to == std::string("nerf") ? "\"./images/" : ".png")) << out;
    }
  EXPECT_THAT(run_tool(dir_, {"convert", "colmap", "a", "--to", "nerf"}).err,
              testing::ContainsRegex("not written, because nerf cannot store them: [0-9]+ points"));
  EXPECT_THAT(run_tool(dir_, {"convert", "llff", "b", "--to", "nerf"}).err, HasSubstr("nearest and farthest depths"));
  EXPECT_THAT(run_tool(dir_, {"convert", "nerf", "c", "--to", "colmap", "--binary"}).err,
              HasSubstr("because colmap cannot store them: the depth of 3 views\n"));
  EXPECT_TRUE(fs::exists(dir_ / "c/sparse/0/points3D.bin"));
}

TEST_F(CameraSets, info_and_view_describe_the_cameras) {
  for (const char* to : {"nerf", "colmap", "llff"}) {
    const nlohmann::json info = report_of(dir_, {"info", to});
    EXPECT_EQ(info["format"], to);
    EXPECT_EQ(info["views"], nlohmann::json({3, 1}));
    const RunResult saved = run_tool(dir_, {"view", to, "--save", std::string(to) + ".html"});
    EXPECT_EQ(saved.exit_code, 0) << saved.err;
    EXPECT_THAT(saved.err, HasSubstr("do not share a plane and a window"));
    EXPECT_TRUE(fs::exists(dir_ / (std::string(to) + ".html")));
  }
}

TEST_F(CameraSets, play_warns_that_the_cameras_share_no_plane) {
  // no machine has this address, so the command ends
  const RunResult played = run_tool(dir_, {"play", "nerf", "--display", "portrait", "--host", "192.0.2.1"});
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_THAT(played.err, HasSubstr("The cameras of nerf do not share a plane and a window. Their views are shown in order"));
}

TEST(CameraSet, render_refuses_videos_and_layouts) {
  const TempDir dir;
  const Words render{"render", "teapot", "--cameras", "circle:3", "-o", "set"};
  expect_refusal(run_tool(dir, render + Words{"--video", "set.mp4"}), 2, "'lippmann encode DIR FILE' after the render");
  expect_refusal(run_tool(dir, render + Words{"--layout", "quilt"}), 2, "--cameras: cannot be combined with --layout");
  EXPECT_FALSE(fs::exists(dir / "set"));
}

}  // namespace
}  // namespace lippmann::test
