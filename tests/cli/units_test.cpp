#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

TEST(Units, processes_have_the_bytes_of_one) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-3", "whole") + Words{"--video", "whole.mkv"});
  for (const char* unit : {"1/2", "2/2"})
    expect_done(dir, small_teapot("0-3", "a") + Words{"--video", "a.mkv", "--unit", unit});
  EXPECT_FALSE(fs::exists(dir / "a.mkv"));
  expect_done(dir, {"finish", "a"});
  expect_done(dir, {"finish", "a", "--quiet"});
  EXPECT_EQ(files_in(dir / "a", ".png"), files_in(dir / "whole", ".png"));
  EXPECT_EQ(bytes_of(dir / "a.mkv"), bytes_of(dir / "whole.mkv"));
}

TEST(Units, finish_prints_commands_for_missing_frames) {
  const TempDir dir;
  for (const char* unit : {"1/3", "3/3"}) expect_done(dir, small_teapot("0-5", "a") + Words{"--unit", unit});
  EXPECT_THAT(run_tool(dir, {"check", "a"}).out, HasSubstr("not rendered yet: frames 2-3\n"));
  fs::resize_file(dir / "a/frame_0005.png", 10);
  const RunResult finish = run_tool(dir, {"finish", "a"});
  EXPECT_EQ(finish.exit_code, 1);
  EXPECT_THAT(finish.out, AllOf(HasSubstr("damaged  frame_0005.png"), HasSubstr("3 of 6 frames have yet to be rendered: 2-3,5"),
                                HasSubstr("render a/job.toml --resume")));
  const Json report = json_of(run_tool(dir, {"finish", "a", "--json"}).out);
  EXPECT_EQ(report["to_render"], Json::array({2, 3, 5}));
  EXPECT_EQ(report["finished"], false);
  expect_done(dir, {"render", "a/job.toml", "--resume"});
  expect_done(dir, {"finish", "a"});
  expect_refusal(run_tool(dir, {"finish", "missing"}), 1, "missing");
}

TEST(Units, plan_explains_single_units) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--units", "4", "--only-list"};
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "3"}).out,
              HasSubstr("A job of one frame is one unit unless it is rendered in strips (--strips).\n"));
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "0-3", "--reuse", "interpolate", "--keyframes", "8"}).out,
              HasSubstr("All frames must be rendered together, so the job is one unit.\n"));
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "0-1"}).out, HasSubstr("The job can be cut into at most 2 units.\n"));
}

TEST(Units, strips_are_planned_rendered_and_joined) {
  const TempDir dir;
  const Words still{"teapot", "--size", "64x64", "--lenses", "8x8", "--frames", "3"};
  expect_done(dir, Words{"render"} + still + Words{"-o", "whole"});
  const Words strips = still + Words{"--strips", "4", "-o", "a"};
  const RunResult plan = run_tool(dir, Words{"plan"} + strips + Words{"--units", "8"});
  EXPECT_THAT(plan.out, AllOf(HasSubstr("2/4  strips 1 of frame 3, about"), HasSubstr("can be cut into at most 4 units"),
                              HasSubstr("'lippmann finish', which joins the strips, takes about")));
  const Json planned = json_of(run_tool(dir, Words{"plan"} + strips + Words{"--units", "2", "--json"}).out);
  EXPECT_EQ(planned["units"][1]["strips"], (Json{{"3", "2-3"}}));
  const RunResult unit = run_tool(dir, Words{"render"} + strips + Words{"--unit", "1/2"});
  EXPECT_THAT(unit.out, HasSubstr("2 strips of 64x64 pixels"));
  EXPECT_THAT(unit.err, HasSubstr("2 strips of 1 frame of 64x64 pixels"));
  EXPECT_THAT(run_tool(dir, {"check", "a"}).out, HasSubstr("not rendered yet: strips 2-3 of frame 3\n"));
  EXPECT_THAT(run_tool(dir, {"finish", "a"}).out, HasSubstr("not rendered yet: strips 2-3 of frame 3\n"));
  expect_done(dir, Words{"render"} + strips + Words{"--unit", "2/2"});
  EXPECT_THAT(run_tool(dir, {"check", "a"}).out, HasSubstr("not joined yet: the strips of frames 3"));
  expect_done(dir, {"finish", "a"});
  expect_done(dir, {"check", "a"});
  EXPECT_TRUE(pictures_below(dir / "a") == pictures_below(dir / "whole"));
  expect_refusal(run_tool(dir, Words{"render"} + still + Words{"--strips", "0"}), 2, "--strips");
  expect_refusal(run_tool(dir, Words{"plan"} + still + Words{"--strips", "5", "--units", "2"}), 2, "5 are too many");
}

TEST(Units, plan_removes_its_temporary_folder) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "0-3", "--units", "2", "-o", "a"};
  fs::create_directory(dir / "scratch");
  const auto run_with = [&](const std::string& tmpdir) {
    return run(Words{"/usr/bin/env", "TMPDIR=" + std::string(dir / tmpdir)} + tool_command(plan), {dir.path().string(), 0});
  };
  EXPECT_EQ(run_with("scratch").exit_code, 0);
  EXPECT_TRUE(fs::is_empty(dir / "scratch"));
  EXPECT_FALSE(fs::exists(dir / "a"));
  expect_refusal(run_with("missing"), 1, "TMPDIR: cannot create a temporary folder");
}

TEST(Units, units_in_several_folders_are_joined) {
  const TempDir dir;
  for (const std::string unit : {"1", "2"}) expect_done(dir, small_teapot("0-3", "part" + unit) + Words{"--unit", unit + "/2"});
  const RunResult part = run_tool(dir, {"finish", "all", "--join", "part1"});
  EXPECT_EQ(part.exit_code, 1) << part.err;
  EXPECT_THAT(part.out, HasSubstr("2 of 4 frames have yet to be rendered: 2-3"));
  expect_done(dir, {"finish", "all", "--join", "part1", "part2"});
}

TEST(Units, only_frames_renders_listed_frames) {
  const TempDir dir;
  const RunResult some = run_tool(dir, small_teapot("0-9", "a") + Words{"--only-frames", "0-1,5-9:2"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_THAT(some.out, HasSubstr("5 frames of"));
}

TEST(Units, plan_prints_frames_and_costs) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "8-31", "--units", "3"};
  const Json measured = report_of(dir, plan), listed = report_of(dir, plan + Words{"--only-list"});
  EXPECT_EQ(measured["units"][1],
            (Json{{"unit", "2/3"}, {"frames", "16-23"}, {"cpu_seconds", measured["units"][1]["cpu_seconds"]}}));
  EXPECT_GT(measured["units"][1]["cpu_seconds"], 0.0);
  EXPECT_GT(measured["peak_memory_bytes"], 1 << 20);
  EXPECT_TRUE(listed["units"][0]["cpu_seconds"].is_null());
  EXPECT_FALSE(fs::exists(dir / "out"));
}

}  // namespace
}  // namespace lippmann::test
