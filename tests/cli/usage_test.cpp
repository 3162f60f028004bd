#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "job/params_table.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(Tool, help_lists_the_commands) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* command : {"render", "info", "scenes", "compare", "convert", "encode", "sheet"})
    EXPECT_THAT(result.out, HasSubstr(command));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("bench")));
}

TEST(Tool, no_command_suggests_three) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_LE(lines_of(result.err), 5u);
  for (const char* words : {"no command", "render teapot ", "view out/teapot ", "view room ", "--help"})
    EXPECT_THAT(result.err, HasSubstr(words));
}

TEST(Tool, render_help_is_short) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"render", "--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_LE(lines_of(result.out), 75u) << "CLI11 wraps long lines from version 2.5 on";
  EXPECT_LT(result.out.find("lippmann render teapot"), result.out.find("--frames"));
  EXPECT_THAT(result.out, HasSubstr("--help-all"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("--halving")));
}

TEST(Tool, help_command_equals_the_help_flag) {
  const TempDir dir;
  for (const Words& words : {Words{"help"}, Words{"help", "help"}})
    EXPECT_EQ(run_tool(dir, words).out, run_tool(dir, {"--help"}).out);
  EXPECT_EQ(run_tool(dir, {"help", "compare"}).out, run_tool(dir, {"compare", "--help"}).out);
}

TEST(Tool, dry_run_makes_nothing) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-8:4", "r") + Words{"-n"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 frames (0 to 8)"));
  EXPECT_THAT(result.out, HasSubstr("128x128 pixels"));
  EXPECT_THAT(result.out, HasSubstr("frame_0000.png ... frame_0008.png\n"));
  EXPECT_FALSE(std::filesystem::exists(dir / "r"));
  const Json plan = report_of(dir, small_teapot("0-8:4", "r") + Words{"--dry-run"});
  EXPECT_EQ(plan["frames"], json_of("[0, 4, 8]"));
  EXPECT_EQ(plan["largest_bytes"], 3 * 3 * 128 * 128);
}

TEST(Tool, dry_run_reports_light_and_view) {
  const TempDir dir;
  const Words render{"render", LIPPMANN_SOURCE "/examples/vase.ply", "--frames", "0", "--dry-run"};
  const RunResult result = run_tool(dir, render);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("  files     frame_0000.png\n"));
  EXPECT_THAT(result.out, HasSubstr("  shading   path traced"));
  EXPECT_THAT(result.out, HasSubstr("  light     The built-in studio"));
  EXPECT_THAT(result.out, HasSubstr("  view      The scene has no camera"));
  const Json plan = report_of(dir, render);
  EXPECT_THAT(plan["light"].get<std::string>(), HasSubstr("studio"));
  EXPECT_THAT(plan["view"].get<std::string>(), HasSubstr("no camera"));
}

TEST(Tool, dry_run_reports_the_quilts_eyes) {
  const TempDir dir;
  const Words sweep{"render", "room",     "--optics", "multiview",    "--views", "23x1",     "--size",
                    "920x30", "--frames", "0",        "--view-angle", "45",      "--dry-run"};
  EXPECT_THAT(run_tool(dir, sweep).out, HasSubstr("  eyes      23 views 1.9565 degrees apart"));
  EXPECT_THAT(run_tool(dir, sweep + Words{"--cone-ends"}).out, HasSubstr("  eyes      23 views 2.0455 degrees apart"));
  expect_refusal(run_tool(dir, small_teapot("0", "r") + Words{"--cone-ends"}), 2, "--cone-ends");
}

TEST(Tool, quiet_commands_print_nothing_on_success) {
  const TempDir dir;
  const RunResult render = run_tool(dir, small_teapot("0-1", "r") + Words{"-q"});
  EXPECT_EQ(render.out + render.err, "");
  EXPECT_TRUE(std::filesystem::exists(dir / "r/frame_0000.png"));
  for (const Words& words : {Words{"check", "r"}, Words{"replay", "r"}, Words{"encode", "r", "r.mkv"},
                             Words{"convert", "r", "v", "--to", "views"}, Words{"convert", "r", "p", "--rotate-elemental"},
                             Words{"convert", "r", "c", "--precompensate", "--crosstalk", "0.4"}}) {
    const RunResult result = run_tool(dir, words + Words{"-q"});
    EXPECT_EQ(result.exit_code, 0) << words[0];
    EXPECT_EQ(result.out + result.err, "") << words[0];
    EXPECT_NE(run_tool(dir, words).out, "") << words[0];
  }
  std::filesystem::remove(dir / "r/frame_0000.png");
  EXPECT_EQ(run_tool(dir, {"check", "r", "--quiet"}).exit_code, 1);
  EXPECT_EQ(run_tool(dir, {"check", "r", "--quiet"}).out, "");
}

TEST(Tool, render_help_all_names_every_parameter) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"render", "--help-all"});
  EXPECT_EQ(result.exit_code, 0);
  for (const ParamInfo& info : params_table())
    if (info.name != "scene") {
      EXPECT_THAT(result.out, HasSubstr("--" + std::string(info.name)));
      EXPECT_THAT(result.out, HasSubstr("--" + std::string(info.opposite)));
    }
}

TEST(Tool, version_names_itself_and_a_number) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"--version"});
  for (const char* flag : {"-v", "-V"}) EXPECT_EQ(run_tool(dir, {flag}).out, result.out);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out.substr(0, result.out.find('\n') + 1), testing::MatchesRegex("lippmann [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Tool, version_lists_libraries) {
  const TempDir dir;
  const std::string out = run_tool(dir, {"--version"}).out;
  EXPECT_THAT(out, testing::ContainsRegex("\ncommit   ([0-9a-f]{12}|not known)\n"));
  EXPECT_THAT(out, testing::ContainsRegex("\ncompiler [A-Za-z]+ [0-9.]+, [A-Za-z]+\n"));
  EXPECT_THAT(out, testing::ContainsRegex("\nEmbree   [34]\\.[0-9.]+\noneTBB   20[0-9.]+\n"));
  EXPECT_THAT(out, testing::ContainsRegex("\nvideos   module installed, for FFmpeg \\(libavcodec [0-9.]+\\)\n"));
  EXPECT_THAT(out, testing::ContainsRegex("\nMPI      module (not )?installed\n"));
}

TEST(Tool, far_misspelling_gets_no_suggestion) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"render", "teapot", "--print"}).err, testing::Not(HasSubstr("--slant")));
}

TEST(Tool, negative_value_is_not_a_flag) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"info", "teapot", "--slant", "-9.46", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NEAR(json_of(result.out)["optics"]["slant_deg"].get<double>(), -9.46, 1e-5);
}

TEST(Tool, scenes_are_listed_as_text_and_json) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"scenes"}).out, HasSubstr("teapot"));
  const Json scenes = json_of(run_tool(dir, {"scenes", "--json"}).out);
  EXPECT_EQ(scenes[0]["name"], "teapot");
  EXPECT_FALSE(scenes[0]["description"].get<std::string>().empty());
}

TEST(Tool, info_describes_the_scene) {
  const TempDir dir;
  const RunResult text = run_tool(dir, {"info", "teapot"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("480 frames"));
  const Json info = json_of(run_tool(dir, {"info", "teapot", "--json"}).out);
  EXPECT_EQ(info["frames"], 480);
  EXPECT_GT(info["triangles"].get<int>(), 1000);
  EXPECT_EQ(info["optics"]["kind"], "lenticular");
  EXPECT_NEAR(info["optics"]["viewing_zone_deg"].get<double>(), 28.0, 0.01);
  EXPECT_LT(info["depth"]["back_mm"].get<double>(), 0.0);
}

TEST(Tool, small_stack_is_an_error) {
  const TempDir dir;
  const std::string render = std::string("ulimit -s 128; exec ") + LIPPMANN_TOOL + " render teapot --frames 0 --lenses 4";
  expect_refusal(run({"sh", "-c", render}, {dir.path().string(), 0}), 1, "ulimit -s: the stack is limited to 128 KB");
}

}  // namespace
}  // namespace lippmann::test
