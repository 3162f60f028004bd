// Tests `compare` with light fields of each format.
#include <gmock/gmock.h>

#include "cli/tool.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::string> folder_formats() {
  std::vector<std::string> names;
  for (const LightFieldFormat& format : light_field_formats())
    if (format.is_folder && format.write != nullptr) names.emplace_back(format.name);
  return names;
}

/// llff cannot store the cameras of a plane, and some other formats store no others.
Words cameras_for(const std::string& format) {
  if (format == "llff") return {"--cameras", "circle:3"};
  return {"--optics", "multiview", "--camera-grid", "--views", "3x1", "--view-angle", "4", "--frames", "0"};
}

/// Has two light fields of three views in each format that is a folder: a_hci, b_hci, a_nerf, b_nerf, ... b is brighter than a.
class CompareFormats : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const std::string& format : folder_formats())
      for (const std::string set : {"a", "b"}) {
        const std::string to = set + "_" + format;
        const bool is_set = format == "llff";
        expect_done(dir(), Words{"render", "teapot", "--size", is_set ? "48x36" : "144x36", "--spp", "1", "--exposure",
                                 set == "a" ? "0" : "0.2", "--to", format, "-q", "-o", is_set ? to : "made"} +
                               cameras_for(format));
        if (!is_set) fs::rename(dir() / "made/frame_0000", dir() / to);
        fs::remove_all(dir() / "made");
      }
  }

  static const TempDir& dir() {
    static const TempDir dir;
    return dir;
  }
};

TEST_F(CompareFormats, all_metrics_agree_and_flicker_is_left_out) {
  nlohmann::json expected;
  for (const std::string& format : folder_formats()) {
    const RunResult result =
        run_tool(dir(), {"compare", "a_" + format, "b_" + format, "--metrics", "all", "--per-view", "--json"});
    EXPECT_EQ(result.exit_code, 0) << format;
    EXPECT_EQ(lines_of(result.err), 1u) << result.err;
    EXPECT_THAT(result.err, HasSubstr("a_" + format + ": flicker needs two or more consecutive frames, so it is left out"));
    nlohmann::json json = json_of(result.out);
    EXPECT_EQ(json["frames"].size(), 3u) << format;
    EXPECT_GT(json["mean"]["flip"], 0.01) << format;
    EXPECT_GT(json["consistency"].at(0)["angular_psnr_db"], 10.0) << format;
    EXPECT_TRUE(json["consistency"].at(0)["flicker"].is_null()) << format;
    for (nlohmann::json& frame : json["frames"]) frame.erase("name");
    json["consistency"].at(0).erase("name");
    if (format == "llff") continue;
    if (expected.is_null()) expected = json;
    EXPECT_EQ(json, expected) << format;
  }
}

TEST_F(CompareFormats, flicker_by_name_is_refused_without_motion) {
  for (const std::string& format : folder_formats()) {
    const std::string set = "two_" + format;
    fs::create_directory(dir() / set);
    for (const char* frame : {"frame_0000", "frame_0001"})
      fs::copy(dir() / ("a_" + format), dir() / set / frame, fs::copy_options::recursive);
    expect_refusal(run_tool(dir(), {"compare", set, set, "--metrics", "flicker"}), 1, set + "/frame_0001: has no motion layer");
    expect_refusal(run_tool(dir(), {"compare", set, set, "--metrics", "all,flicker"}), 1, "has no motion layer");
    const RunResult all = run_tool(dir(), {"compare", set, set, "--metrics", "all"});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(lines_of(all.err), 1u) << all.err;
    EXPECT_THAT(all.err, HasSubstr("frame_0001: has no motion layer, which the metric flicker needs, so it is left out\n"));
  }
  expect_refusal(run_tool(dir(), {"compare", "a_hci", "b_hci", "--metrics", "flicker"}), 2, "two or more consecutive frames");
}

TEST_F(CompareFormats, pictures_of_several_views_have_all_metrics) {
  for (const std::string to : {"rgbd", "stereo", "quad", "quilt", "eslf", "integral"}) {
    const Words optics = to == "stereo" ? Words{} : Words{"--optics", "multiview", "--views", "4x1"};
    const Words render = {"render", "teapot", "--size", "96x24", "--frames", "0",      "--spp",
                          "1",      "--to",   to,       "-q",    "-o",       "p_" + to};
    expect_done(dir(), render + optics);
    const RunResult result = run_tool(dir(), {"compare", "p_" + to, "p_" + to, "--metrics", "all", "--json"});
    EXPECT_THAT(result.err, HasSubstr("flicker needs two or more consecutive frames, so it is left out")) << to;
    const nlohmann::json json = json_of(result.out);
    EXPECT_EQ(json["frames"].size(), to == "rgbd" ? 1u : to == "stereo" ? 2u : 4u) << to;
    EXPECT_TRUE(json["identical"]) << to;
  }
}

TEST_F(CompareFormats, pictures_without_views_have_all_other_metrics) {
  for (const std::string set : {"a", "b"}) fs::copy_file(dir() / (set + "_hci/input_Cam000.png"), dir() / (set + ".png"));
  const RunResult all = run_tool(dir(), {"compare", "a.png", "b.png", "--metrics", "all", "--json"});
  EXPECT_THAT(all.err, HasSubstr("a.png: no file states its views, so the metrics angular and flicker are left out"));
  EXPECT_EQ(lines_of(all.err), 1u);
  const nlohmann::json json = json_of(all.out);
  EXPECT_GT(json["frames"].at(0)["flip"], 0.01);
  EXPECT_FALSE(json.contains("consistency"));
  expect_refusal(run_tool(dir(), {"compare", "a.png", "b.png", "--metrics", "angular"}), 2, "the format of a.png is unknown");
}

TEST_F(CompareFormats, motion_of_some_frames_gives_flicker_there) {
  expect_done(dir(), {"render", "teapot", "--optics", "multiview", "--views", "2x1", "--size", "40x24", "--frames", "0-2",
                      "--spp", "1", "--layout", "views", "--aov", "motion", "-q", "-o", "moving"});
  const Words all = {"compare", "moving", "moving", "--metrics", "all", "--json"};
  const RunResult whole = run_tool(dir(), all);
  EXPECT_EQ(whole.err, "");
  EXPECT_EQ(json_of(whole.out)["consistency"].at(2)["flicker"], 0.0);
  fs::remove_all(dir() / "moving/.lippmann");  // without the journal, a missing file is not reported as damage
  fs::remove(dir() / "moving/frame_0001/aov_000.exr");
  const RunResult part = run_tool(dir(), all);
  EXPECT_THAT(part.err, HasSubstr("moving/frame_0001: has no motion layer"));
  EXPECT_THAT(part.err, HasSubstr("so it is left out for 1 of 2 frames"));
  EXPECT_TRUE(json_of(part.out)["consistency"].at(1)["flicker"].is_null());
  EXPECT_EQ(json_of(part.out)["consistency"].at(2)["flicker"], 0.0);
}

}  // namespace
}  // namespace lippmann::test
