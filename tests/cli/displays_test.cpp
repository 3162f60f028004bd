#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Displays, list_and_json_have_the_presets) {
  const TempDir dir;
  const RunResult list = run_tool(dir, {"displays"}), json = run_tool(dir, {"displays", "--json"});
  EXPECT_EQ(list.exit_code, 0);
  const auto displays = json_of(json.out);
  EXPECT_GE(displays.size(), 20u);
  for (const auto& display : displays) EXPECT_THAT(list.out, HasSubstr(display["name"].get<std::string>()));
}

TEST(Displays, one_display_shows_its_lenses) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"displays", "portrait"}).out, HasSubstr("244.041"));
  const auto json = json_of(run_tool(dir, {"displays", "portrait", "--json"}).out);
  EXPECT_NEAR(json["periods"].get<double>(), 244.041, 5e-4);
  EXPECT_NEAR(json["tilt"].get<double>(), -0.190476, 5e-7);
}

TEST(Displays, find_reads_a_devices_calibration) {
  const TempDir dir;
  std::filesystem::create_directories(dir / "media/me/LKG/LKG_calibration");
  const auto file = dir / "media/me/LKG/LKG_calibration/visual.json";
  std::ofstream(file)
      << R"({"serial": "LKG-J00042", "pitch": 44, "slope": -7, "center": 0.1, "DPI": 566, "screenW": 7680, "screenH": 4320})";
  const std::string mounts = (dir / "media").string();
  const RunResult text = run_tool(dir, {"displays", "--find", "--mounts", mounts});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("lippmann render SCENE --display '" + file.string() + "'"));
  EXPECT_THAT(text.out, HasSubstr("LKG-J00042, 7680x4320 pixels")) << "the panel of the device overrides its model";
  const auto json = json_of(run_tool(dir, {"displays", "--find", "--mounts", mounts, "--json"}).out);
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["file"], file.string());
  EXPECT_EQ(json[0]["pixels"], nlohmann::json({7680, 4320}));
}

TEST(Displays, find_reports_calibration_errors_and_places) {
  const TempDir dir;
  std::filesystem::create_directories(dir / "media/LKG");
  const std::string mounts = (dir / "media").string();
  expect_refusal(run_tool(dir, {"displays", "--find", "--mounts", mounts}), 1, "below " + mounts);
  EXPECT_EQ(json_of(run_tool(dir, {"displays", "--find", "--mounts", mounts, "--json"}).out), nlohmann::json::array());
  std::ofstream(dir / "media/LKG/visual.json") << "{";
  EXPECT_THAT(run_tool(dir, {"displays", "--find", "--mounts", mounts}).out, HasSubstr("visual.json"));
  EXPECT_TRUE(json_of(run_tool(dir, {"displays", "--find", "--mounts", mounts, "--json"}).out)[0].contains("error"));
  expect_refusal(run_tool(dir, {"displays", "--mounts", mounts}), 2, "--find");
}

TEST(Displays, depth_budgets_differ_for_panel_and_quilt) {
  const TempDir dir;
  const auto json = json_of(run_tool(dir, {"displays", "portrait", "--json"}).out);
  // Depth budget of the quilt, by similar triangles: p D / (a + p). The pixel of a view is p = 120.4 mm / 420 wide. The
  // 48 views cover 40 degrees, so at distance D neighbouring eyes are a = 2 D tan(40 / 48 / 2 degrees) apart.
  const double distance = json["viewing_distance_mm"], pixel = json["size_mm"][0].get<double>() / 420.0;
  const double apart = 2.0 * distance * std::tan(20.0 / 48.0 * 3.14159265358979 / 180.0);
  EXPECT_NEAR(json["quilt"]["depth_budget_mm"].get<double>(), pixel * distance / (apart + pixel), 1e-3);
  EXPECT_NE(json["quilt"]["depth_budget_mm"], json["depth_budget_mm"]);
}

TEST(Displays, unknown_names_and_bad_files_fail) {
  const TempDir dir;
  std::ofstream(dir / "visual.json") << R"({"serial": "LKG-P1", "pitch": 0, "slope": -7, "center": 0})";
  const RunResult name = run_tool(dir, {"displays", "portrat"}), file = run_tool(dir, {"displays", "visual.json"});
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_THAT(name.err, HasSubstr("'portrait'"));
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_THAT(file.err, HasSubstr("visual.json: pitch"));
  EXPECT_EQ(name.out + file.out, "");
}

}  // namespace
}  // namespace lippmann::test
