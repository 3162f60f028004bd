// `lippmann displays`, and `convert` to and from a slanted panel's own frame.
#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Displays, list_names_presets_and_json_says_the_same) {
  const TempDir dir;
  const RunResult list = run_tool(dir, {"displays"}), json = run_tool(dir, {"displays", "--json"});
  EXPECT_EQ(list.exit_code, 0);
  const auto displays = json_of(json.out);
  EXPECT_GE(displays.size(), 20u);
  for (const auto& display : displays) EXPECT_THAT(list.out, HasSubstr(display["name"].get<std::string>()));
}

TEST(Displays, one_by_name_tells_its_lenses) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"displays", "portrait"}).out, HasSubstr("244.041"));
  const auto json = json_of(run_tool(dir, {"displays", "portrait", "--json"}).out);
  EXPECT_NEAR(json["periods"].get<double>(), 244.041, 5e-4);
  EXPECT_NEAR(json["tilt"].get<double>(), -0.190476, 5e-7);
}

TEST(Displays, unknown_names_are_wrong_usage_and_bad_files_failed_work) {
  const TempDir dir;
  std::ofstream(dir / "visual.json") << R"({"serial": "LKG-P1", "pitch": 0, "slope": -7, "center": 0})";
  const RunResult name = run_tool(dir, {"displays", "portrat"}), file = run_tool(dir, {"displays", "visual.json"});
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_THAT(name.err, HasSubstr("'portrait'"));
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_THAT(file.err, HasSubstr("visual.json: pitch"));
  EXPECT_EQ(name.out + file.out, "");
}

TEST(Displays, native_frame_of_a_quilt_for_a_calibration_taken_apart_and_made_again_is_the_same) {
  const TempDir dir;
  std::ofstream(dir / "visual.json") << R"({"serial": "DIY", "pitch": {"value": 20}, "slope": {"value": -5.5},
    "center": {"value": 0.2}, "DPI": 100, "screenW": 120, "screenH": 160})";
  ASSERT_EQ(run_tool(dir, {"render", "room", "--optics", "multiview", "--views", "4x2", "--size", "240x160", "--frames", "0-0",
                           "--output", "quilt", "--layout", "quilt"})
                .exit_code,
            0);
  const std::string quilt = files_in(dir / "quilt", ".png").begin()->first;
  const Words panel{"--display", "visual.json"};
  ASSERT_EQ(
      run_tool(dir, Words{"convert", "quilt/" + quilt, "panel.png", "--from", "quilt", "--to", "native"} + panel).exit_code, 0);
  ASSERT_EQ(run_tool(dir, Words{"convert", "panel.png", "views", "--from", "native", "--to", "views", "--views", "8x1"} + panel)
                .exit_code,
            0);
  EXPECT_EQ(files_in(dir / "views", ".png").size(), 8u);
  ASSERT_EQ(run_tool(dir, Words{"convert", "views", "again.png", "--from", "views", "--to", "native"} + panel).exit_code, 0);
  EXPECT_EQ(json_of(run_tool(dir, {"compare", "panel.png", "again.png", "--json"}).out)["identical"], true);
}

TEST(Displays, native_needs_a_slanted_panel) {
  const TempDir dir;
  const RunResult none = run_tool(dir, {"convert", "a.png", "b.png", "--from", "native", "--to", "views"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("--display"));
}

}  // namespace
}  // namespace lippmann::test
