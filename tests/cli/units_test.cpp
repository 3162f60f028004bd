// A job rendered in parts: plan, render --unit, finish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// 24 frames of 8 lenses in kinds of reuse that cut animations in different places.
struct Kind {
  const char* name;
  Words flags;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"copy", {"--reuse", "copy", "--keyframes", "5"}},
                                     {"interpolate", {"--reuse", "interpolate", "--keyframes", "4"}},
                                     {"floor", {"--reuse", "interpolate", "--keyframes", "2", "--min-psnr", "40"}},
                                     {"light", {"--integrator", "path", "--spp", "4"}},
                                     {"denoise", {"--integrator", "path", "--spp", "2", "--reuse", "none", "--denoise"}}};
  return all;
}

Words job(const Kind& kind, const std::string& folder) {
  return Words{"render", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "8-31", "-o", folder} + kind.flags;
}

TEST(Units, rendered_beside_each_other_in_any_number_give_the_bytes_of_one_run_and_finish_its_video) {
  for (const Kind& kind : kinds()) {
    const TempDir dir;
    expect_done(dir, job(kind, "whole") + Words{"--video", "whole.mp4"});
    for (const int count : {2, 5}) {
      const std::string folder = "parts-" + std::to_string(count), video = folder + ".mp4";
      std::vector<std::thread> tasks;
      for (int unit = 1; unit <= count; ++unit)
        tasks.emplace_back([&, unit] {
          expect_done(
              dir, job(kind, folder) + Words{"--video", video, "--unit", std::to_string(unit) + "/" + std::to_string(count)});
        });
      for (std::thread& task : tasks) task.join();
      EXPECT_FALSE(fs::exists(dir / video));
      expect_done(dir, {"finish", folder});
      EXPECT_EQ(files_in(dir / folder, ".png"), files_in(dir / "whole", ".png")) << kind.name << count;
      EXPECT_EQ(bytes_of(dir / video), bytes_of(dir / "whole.mp4")) << kind.name;
      expect_done(dir, {"check", folder});
      const nlohmann::json report = json_of(bytes_of(dir / folder / "report.json"));
      EXPECT_EQ(report["frames"].size(), 24u);
      EXPECT_EQ(report["interrupted"], false);
      EXPECT_EQ(report["runs"].size(), static_cast<std::size_t>(count) + 1);
    }
  }
}

TEST(Units, finish_names_what_is_missing_and_the_command_that_it_prints_renders_it) {
  const TempDir dir;
  const Words teapot = small_teapot("0-5", "a") + Words{"--video", "a.mkv"};
  for (const char* unit : {"1/3", "3/3"}) expect_done(dir, teapot + Words{"--unit", unit});
  const RunResult check = run_tool(dir, {"check", "a"});
  EXPECT_THAT(check.out, HasSubstr("not rendered yet: frames 2-3\n"));
  fs::resize_file(dir / "a/frame_0005.png", 10);
  const RunResult finish = run_tool(dir, {"finish", "a"});
  EXPECT_EQ(finish.exit_code, 1);
  EXPECT_THAT(finish.out,
              testing::AllOf(HasSubstr("damaged  frame_0005.png"), HasSubstr("3 of 6 frames are to be rendered: 2-3,5"),
                             HasSubstr("render a/job.toml --resume")));
  EXPECT_FALSE(fs::exists(dir / "a.mkv"));
  const nlohmann::json json = json_of(run_tool(dir, {"finish", "a", "--json"}).out);
  EXPECT_EQ(json["to_render"], nlohmann::json::array({2, 3, 5}));
  EXPECT_EQ(json["finished"], false);
  expect_done(dir, {"render", "a/job.toml", "--resume"});
  expect_done(dir, {"check", "a"});
  expect_done(dir, {"finish", "a"});
  expect_done(dir, {"finish", "a", "--quiet"});
}

TEST(Units, parts_in_folders_of_their_own_are_joined) {
  const TempDir dir;
  for (const char* unit : {"1", "2"})
    expect_done(dir, small_teapot("0-3", std::string("part") + unit) + Words{"--unit", std::string(unit) + "/2"});
  const RunResult part = run_tool(dir, {"finish", "all", "--join", "part1"});
  EXPECT_EQ(part.exit_code, 1) << part.err;
  EXPECT_THAT(part.out, HasSubstr("2 of 4 frames are to be rendered: 2-3"));
  EXPECT_TRUE(fs::exists(dir / "all/job.toml"));
  expect_done(dir, {"finish", "all", "--join", "part1", "part2"});
  expect_done(dir, {"check", "all"});
  expect_done(dir, small_teapot("0-3", "whole"));
  EXPECT_EQ(files_in(dir / "all", ".png"), files_in(dir / "whole", ".png"));
  EXPECT_THAT(run_tool(dir, {"render", "all/job.toml", "--resume"}).out, HasSubstr("4 kept"));
}

TEST(Units, beyond_the_segments_of_a_job_have_nothing_to_do_and_succeed) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-1", "a") + Words{"--unit", "3/3", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("unit 3/3 has no frames"));
}

TEST(Units, only_frames_renders_these_of_the_job_and_finish_knows_what_is_missing) {
  const TempDir dir;
  const Words teapot = small_teapot("0-9", "a") + Words{"--video", "a.mkv"};
  const RunResult some = run_tool(dir, teapot + Words{"--only-frames", "0-1,5-9:2"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_THAT(some.out, HasSubstr("5 frames of"));
  EXPECT_FALSE(fs::exists(dir / "a.mkv"));
  EXPECT_THAT(run_tool(dir, {"check", "a"}).out, HasSubstr("not rendered yet: frames 2-4,6,8\n"));
  EXPECT_THAT(run_tool(dir, {"finish", "a"}).out, HasSubstr("5 of 10 frames are to be rendered: 2-4,6,8"));
  expect_done(dir, {"render", "a/job.toml", "--resume", "--only-frames", "2-4,6,8"});
  expect_done(dir, {"finish", "a"});
  expect_done(dir, small_teapot("0-9", "whole") + Words{"--video", "whole.mkv"});
  EXPECT_EQ(files_in(dir / "a", ".png"), files_in(dir / "whole", ".png"));
  EXPECT_EQ(bytes_of(dir / "a.mkv"), bytes_of(dir / "whole.mkv"));
}

TEST(Units, only_frames_are_those_of_the_unit_too) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-5", "a") + Words{"--unit", "2/3", "--only-frames", "3-5"});
  EXPECT_EQ(files_in(dir / "a", ".png").size(), 1u);
  EXPECT_TRUE(fs::exists(dir / "a/frame_0003.png"));
}

TEST(Units, only_frames_of_which_the_job_has_none_are_refused) {
  const TempDir dir;
  expect_refusal(run_tool(dir, small_teapot("0-5", "a") + Words{"--only-frames", "7-9"}), 2,
                 "--only-frames: 7-9 has no frame that is to be rendered; accepted: some of 0-5");
  expect_refusal(run_tool(dir, small_teapot("0-5", "a") + Words{"--only-frames", "x"}), 2, "--only-frames: 'x'");
  expect_refusal(run_tool(dir, small_teapot("0-5", "a") + Words{"--only-frames", "0", "--page"}), 2,
                 "--page: needs all frames, and --only-frames 0 renders a part of them");
  EXPECT_FALSE(fs::exists(dir / "a"));
}

TEST(Units, of_pictures_without_the_codes_of_a_video_are_refused) {
  const TempDir dir;
  const Words command = small_teapot("0-1", "a") + Words{"--video", "a.mp4", "--format", "exr", "--unit", "1/2"};
  expect_refusal(run_tool(dir, command), 2, "--video: is made of the pictures of all parts");
  expect_refusal(run_tool(dir, small_teapot("0-1", "a") + Words{"--unit", "3/2"}), 2, "--unit: '3/2' is no unit");
  expect_refusal(run_tool(dir, {"finish", "missing"}), 1, "missing");
}

TEST(Units, plan_says_why_a_job_is_one_unit) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--units", "4", "--only-list"};
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "3"}).out, HasSubstr("One frame is one unit: pictures are not cut.\n"));
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "0-3", "--integrator", "path"}).out,
              HasSubstr("All frames are made together: the job is one unit.\n"));
  EXPECT_THAT(run_tool(dir, plan + Words{"--frames", "0-1"}).out, HasSubstr("The job falls into 2 units at most.\n"));
}

TEST(Units, plan_measures_in_a_folder_that_it_removes) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "0-3", "--units", "2", "-o", "a"};
  fs::create_directory(dir / "scratch");
  const auto run_with = [&](const std::string& tmpdir) {
    return run(Words{"/usr/bin/env", "TMPDIR=" + std::string(dir / tmpdir)} + tool_command(plan), {dir.path().string(), 0});
  };
  EXPECT_EQ(run_with("scratch").exit_code, 0);
  EXPECT_TRUE(fs::is_empty(dir / "scratch"));
  EXPECT_FALSE(fs::exists(dir / "a"));
  expect_refusal(run_with("missing"), 1, "TMPDIR: no folder can be made there");
}

TEST(Units, plan_lists_every_frame_once_and_what_units_take) {
  const TempDir dir;
  const Words plan{"plan", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "8-31", "--json"};
  const nlohmann::json measured = json_of(run_tool(dir, plan + Words{"--units", "3"}).out);
  EXPECT_EQ(measured["units"].size(), 3u);
  EXPECT_EQ(measured["units"][1],
            (nlohmann::json{{"unit", "2/3"}, {"frames", "16-23"}, {"cpu_seconds", measured["units"][1]["cpu_seconds"]}}));
  EXPECT_GT(measured["units"][0]["cpu_seconds"], 0.0);
  EXPECT_GT(measured["peak_memory_bytes"], 1 << 20);
  const nlohmann::json light = json_of(run_tool(dir, plan + Words{"--units", "9", "--only-list", "--integrator", "path"}).out);
  EXPECT_EQ(light["segment"], 16);
  EXPECT_EQ(light["units"].size(), 2u);
  EXPECT_EQ(light["units"][0]["frames"], "8-15");
  EXPECT_TRUE(light["units"][0]["cpu_seconds"].is_null());
  EXPECT_FALSE(fs::exists(dir / "out"));
}

}  // namespace
}  // namespace lippmann::test
