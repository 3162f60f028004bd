#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "job/params_table.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(Tool, help_lists_the_commands_and_exits_with_0) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* command : {"render", "info", "scenes", "compare", "convert", "encode", "bench"})
    EXPECT_THAT(result.out, HasSubstr(command));
}

TEST(Tool, render_help_is_short_and_shows_examples_first) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"render", "--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_LE(lines_of(result.out), 60u);
  EXPECT_LT(result.out.find("lippmann render teapot"), result.out.find("--frames"));
  EXPECT_THAT(result.out, HasSubstr("--help-all"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("--halving")));
}

TEST(Tool, help_of_a_command_is_its_help_flag) {
  const TempDir dir;
  for (const Words& words : {Words{"help"}, Words{"help", "help"}})
    EXPECT_EQ(run_tool(dir, words).out, run_tool(dir, {"--help"}).out);
  EXPECT_EQ(run_tool(dir, {"help", "compare"}).out, run_tool(dir, {"compare", "--help"}).out);
  expect_refusal(run_tool(dir, {"help", "rendre"}), 2, "did you mean 'render'?");
}

TEST(Tool, misspelt_values_are_answered_with_the_nearest) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--optics", "lentcular"}), 2, "did you mean 'lenticular'?");
  expect_refusal(run_tool(dir, {"render", "teapott"}), 1, "did you mean 'teapot'?");
  expect_refusal(run_tool(dir, {"render", "teapot", "--display", "60lpi"}), 2, "did you mean '");
  EXPECT_THAT(run_tool(dir, {"render", "teapot", "--print"}).err, testing::Not(HasSubstr("--slant")));
  const Words render{"render", "teapot", "--dry-run"};
  expect_refusal(run_tool(dir, render + Words{"--environment", "studo"}), 2, "there is no 'studo', did you mean 'studio'?");
  expect_refusal(run_tool(dir, render + Words{"--format", "pgn"}), 2, "did you mean 'png'?");
  expect_refusal(run_tool(dir, render + Words{"--also", "singel"}), 2, "did you mean 'single'?; accepted: single");
  expect_refusal(run_tool(dir, render + Words{"--progress", "jsn"}), 2, "did you mean 'json'?; accepted: json");
  expect_refusal(run_tool(dir, render + Words{"--keyframes", "atuo"}), 2, "accepted: auto, or a whole number from 2");
  expect_refusal(run_tool(dir, {"bench", "papr"}), 2, "did you mean 'paper'?");
}

TEST(Tool, dry_run_says_what_would_be_made_and_makes_nothing) {
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

TEST(Tool, dry_run_says_which_light_and_view_were_chosen) {
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

TEST(Tool, quiet_render_prints_nothing) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0", "r") + Words{"-q"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_TRUE(std::filesystem::exists(dir / "r" / "frame_0000.png"));
}

TEST(Tool, quiet_commands_print_nothing_where_all_is_well) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0-1", "r")).exit_code, 0);
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
  EXPECT_THAT(result.out, testing::MatchesRegex("lippmann [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Tool, no_command_or_an_unknown_one_is_wrong_usage) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {}), 2, "--help");
  expect_refusal(run_tool(dir, {"rendre"}), 2, "did you mean 'render'?");
}

TEST(Tool, unknown_flag_is_wrong_usage_and_suggests_the_nearest) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--lense", "3"}), 2, "did you mean '--lenses'?");
  expect_refusal(run_tool(dir, {"render", "teapot", "--reuse", "exactly"}), 2, "--reuse");
}

TEST(Tool, convert_says_what_it_made_and_refuses_what_is_no_grid) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "r")).exit_code, 0);
  const Words convert{"convert", "r/frame_0000.png", "q.png", "--from", "integral", "--to", "quilt"};
  const RunResult made = run_tool(dir, convert + Words{"--views", "8x1", "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Json report = json_of(made.out);
  EXPECT_EQ(report["view_size"], json_of("[16, 128]"));
  EXPECT_TRUE(std::filesystem::exists(dir / report["files"][0].get<std::string>()));
  for (const char* grid : {"8", "8x", "x1", "0x1", "8x1x2", "-8x1", "99999x1"})
    expect_refusal(run_tool(dir, convert + Words{"--views", grid}), 2, "--views");
  EXPECT_EQ(run_tool(dir, convert).exit_code, 0) << "the report beside it says how many views there are";
  std::filesystem::copy(dir / "r/frame_0000.png", dir / "alone.png");
  expect_refusal(run_tool(dir, {"convert", "alone.png", "q.png", "--from", "integral", "--to", "quilt"}), 2, "--views");
  expect_refusal(run_tool(dir, {"convert", "alone.png", "q.png", "--to", "quilt"}), 2, "--from");
}

TEST(Tool, flag_given_twice_or_without_a_value_is_wrong_usage) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--spp", "1", "--spp", "2"}), 2, "--spp");
  expect_refusal(run_tool(dir, {"render", "teapot", "--spp"}), 2, "--spp");
}

TEST(Tool, bad_value_is_wrong_usage_and_says_what_is_accepted) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--spp", "-1"}), 2, "from 0 to 65536");
  expect_refusal(run_tool(dir, {"render", "teapot", "--optics", "fresnel"}), 2, "lenticular, microlens, multiview, single");
  expect_refusal(run_tool(dir, {"render", "teapot", "--size", "0x0"}), 2, "--size");
  expect_refusal(run_tool(dir, {"render", "teapot", "--lens-pixels", "0"}), 2, "--lens-pixels");
  expect_refusal(run_tool(dir, {"render", "teapot", "--size", "40000x25000"}), 2, "accepted: up to 268435456 pixels");
}

TEST(Tool, negative_value_is_a_value_and_not_a_flag) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"info", "teapot", "--slant", "-9.46", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NEAR(json_of(result.out)["optics"]["slant_deg"].get<double>(), -9.46, 1e-5);
}

TEST(Tool, scenes_lists_the_built_in_ones_as_text_and_json) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"scenes"}).out, HasSubstr("teapot"));
  const Json scenes = json_of(run_tool(dir, {"scenes", "--json"}).out);
  EXPECT_EQ(scenes[0]["name"], "teapot");
  EXPECT_FALSE(scenes[0]["description"].get<std::string>().empty());
}

TEST(Tool, info_tells_contents_animation_array_and_depth) {
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

TEST(Tool, stack_that_is_too_small_is_an_error_and_not_a_crash) {
  const TempDir dir;
  const std::string render = std::string("ulimit -s 128; exec ") + LIPPMANN_TOOL + " render teapot --frames 0 --lenses 4";
  expect_refusal(run({"sh", "-c", render}, {dir.path().string(), 0}), 1, "ulimit -s: the stack is limited to 128 KB");
}

}  // namespace
}  // namespace lippmann::test
