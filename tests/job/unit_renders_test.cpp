#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "core/frame_ranges.hpp"
#include "job/finish_animation.hpp"
#include "job/renders.hpp"
#include "job/unit_plan.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class UnitRenders : public Renders {
 protected:
  void render_unit(const RenderParams& params, int unit, int count) const {
    Context context;
    context.threads = 1;
    render_animation(ResolvedJob(params), context, {}, {.units = Units{{unit}, count}});
  }

  FinishedAnimation finish(const std::string& folder, const std::vector<fs::path>& join = {}) const {
    return finish_animation(dir_ / folder, join, context_);
  }
};

/// Returns settings of jobs with 24 frames. Each kind of reuse may divide the animation among processes at different
/// frames.
const std::vector<Settings>& kinds() {
  static const std::vector<Settings> all{{{"reuse", "copy"}, {"keyframes", "5"}},
                                         {{"reuse", "interpolate"}, {"keyframes", "4"}},
                                         {{"reuse", "interpolate"}, {"keyframes", "2"}, {"min-psnr", "40"}},
                                         {{"integrator", "path"}, {"spp", "4"}},
                                         {{"integrator", "path"}, {"spp", "2"}, {"denoise", "none"}}};
  return all;
}

TEST_F(UnitRenders, units_have_the_bytes_of_one_run) {
  for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
    const auto film = [&](const std::string& folder) {
      const Settings small{{"size", "64x16"}, {"lenses", "8x2"}, {"frames", "8-31"}, {"video", dir_ / (folder + ".mp4")}};
      return job("primitives", folder, small + kinds()[kind]);
    };
    const std::string name = std::to_string(kind), whole = name + "-whole";
    render(film(whole));
    for (const int count : {2, 5}) {
      const std::string folder = name + "-in-" + std::to_string(count);
      std::vector<std::thread> tasks;
      for (int unit = 1; unit <= count; ++unit) tasks.emplace_back([&, unit] { render_unit(film(folder), unit, count); });
      for (std::thread& task : tasks) task.join();
      EXPECT_FALSE(exists(folder + ".mp4"));
      const FinishedAnimation finished = finish(folder);
      ASSERT_TRUE(finished.report) << kind;
      const auto report = nlohmann::json::parse(bytes(folder + "/report.json"));
      EXPECT_EQ(report["frames"].size(), 24u);
      EXPECT_EQ(report["interrupted"], false);
      EXPECT_EQ(report["runs"].size(), static_cast<std::size_t>(count) + 1);
      EXPECT_EQ(files_in(dir_ / folder, ".png"), files_in(dir_ / whole, ".png")) << kind << " " << count;
      EXPECT_EQ(bytes(folder + ".mp4"), bytes(whole + ".mp4")) << kind;
      EXPECT_TRUE(check(folder).passed());
    }
  }
}

TEST_F(UnitRenders, missing_frames_are_named_and_resumed) {
  const RenderParams params = teapot("a", "0-5", {{"video", dir_ / "a.mkv"}});
  for (const int unit : {1, 3}) render_unit(params, unit, 3);
  EXPECT_THAT(check("a").unfinished, ElementsAre(2, 3));
  fs::resize_file(dir_ / "a/frame_0005.png", 10);
  const FinishedAnimation unfinished = finish("a");
  EXPECT_FALSE(unfinished.report);
  EXPECT_THAT(unfinished.check.damaged, ElementsAre("frame_0005.png"));
  EXPECT_THAT(unfinished.to_render, ElementsAre(2, 3, 5));
  EXPECT_FALSE(exists("a.mkv"));
  resume(job_of("a"));
  EXPECT_TRUE(check("a").passed());
  EXPECT_TRUE(finish("a").report);
  EXPECT_TRUE(finish("a").report) << "a second time";
}

// Does not test `copy`, because its runs choose different source frames, so that the provenance differs.
TEST_F(UnitRenders, provenance_equals_that_of_one_run) {
  const std::vector<Settings> ways{{{"reuse", "interpolate"}, {"keyframes", "4"}},
                                   {{"reuse", "interpolate"}, {"keyframes", "2"}, {"min-psnr", "40"}},
                                   {{"integrator", "path"}, {"spp", "8"}},
                                   {{"reuse", "none"}}};
  for (std::size_t way = 0; way < ways.size(); ++way) {
    SCOPED_TRACE(way);
    const auto film = [&](const std::string& folder) {
      const Settings small{{"size", "64x16"}, {"lenses", "8x2"}, {"frames", "8-19"}, {"aov", "provenance"}};
      return job("primitives", folder + std::to_string(way), small + ways[way]);
    };
    render(film("whole"));
    const Files whole = pictures_below(dir_ / ("whole" + std::to_string(way)));
    ASSERT_EQ(whole.size(), 24u);
    render(film("resumed"));
    for (const char* lost : {"/frame_0010.png", "/aov_0013.exr"}) fs::remove(film("resumed").output.folder + lost);
    EXPECT_EQ(kept(resume(film("resumed"))), 10u);
    EXPECT_TRUE(pictures_below(film("resumed").output.folder) == whole);
    for (const int unit : {3, 1, 2}) render_unit(film("units"), unit, 3);
    EXPECT_TRUE(pictures_below(film("units").output.folder) == whole);
  }
}

TEST_F(UnitRenders, units_in_several_folders_are_joined) {
  for (const int unit : {1, 2}) render_unit(teapot("part" + std::to_string(unit), "0-3"), unit, 2);
  EXPECT_THAT(finish("all", {dir_ / "part1"}).to_render, ElementsAre(2, 3));
  EXPECT_TRUE(exists("all/job.toml"));
  EXPECT_TRUE(finish("all", {dir_ / "part1", dir_ / "part2"}).report);
  EXPECT_TRUE(check("all").passed());
  EXPECT_EQ(rendered(teapot("whole", "0-3")), files_in(dir_ / "all", ".png"));
  EXPECT_EQ(kept(resume(job_of("all"))), 4u);
}

TEST_F(UnitRenders, units_beyond_the_segments_succeed) {
  render(teapot("a", "0-1"), {.units = Units{{3}, 3}});
  EXPECT_THAT(warnings_, HasSubstr("unit 3/3 has no frames"));
}

TEST_F(UnitRenders, listed_frames_leave_the_others) {
  const RenderParams params = teapot("a", "0-9", {{"video", dir_ / "a.mkv"}});
  const RenderReport some = render(params, {.only_frames = read_frames("0-1,5-9:2", "")});
  EXPECT_EQ(some.frames.size(), 5u);
  EXPECT_FALSE(exists("a.mkv"));
  EXPECT_THAT(check("a").unfinished, ElementsAre(2, 3, 4, 6, 8));
  EXPECT_THAT(finish("a").to_render, ElementsAre(2, 3, 4, 6, 8));
  RenderParams rest = job_of("a");
  rest.resume = true;
  render(rest, {.only_frames = read_frames("2-4,6,8", "")});
  EXPECT_TRUE(finish("a").report);
  EXPECT_EQ(rendered(teapot("whole", "0-9", {{"video", dir_ / "whole.mkv"}})), files_in(dir_ / "a", ".png"));
  EXPECT_EQ(bytes("a.mkv"), bytes("whole.mkv"));
}

TEST_F(UnitRenders, listed_frames_are_limited_to_the_unit) {
  render(teapot("a", "0-5"), {.units = Units{{2}, 3}, .only_frames = FrameRanges{{3, 5}}});
  EXPECT_EQ(files_in(dir_ / "a", ".png").size(), 1u);
  EXPECT_TRUE(exists("a/frame_0003.png"));
}

TEST_F(UnitRenders, impossible_units_are_refused) {
  EXPECT_THAT(refusal(teapot("a", "0-5"), {.only_frames = FrameRanges{{7, 9}}}),
              HasSubstr("only-frames: 7-9 selects no frame of this render; accepted: frames among 0-5"));
  EXPECT_THAT(refusal(teapot("a", "0-1", {{"video", dir_ / "a.mp4"}, {"format", "exr"}}), {.units = Units{{1}, 2}}),
              HasSubstr("video: needs 8-bit pictures"));
  EXPECT_THAT(error_message([&] { finish("missing"); }), HasSubstr("missing"));
  EXPECT_FALSE(exists("a"));
}

TEST_F(UnitRenders, plan_has_every_frame_once) {
  const Settings film{{"size", "64x16"}, {"lenses", "8x2"}, {"frames", "8-31"}};
  const UnitPlan measured = plan_units(ResolvedJob(job("teapot", "out", film)), 3, true, context_);
  ASSERT_EQ(measured.units.size(), 3u);
  EXPECT_THAT(measured.units[1].frames, ElementsAre(16, 17, 18, 19, 20, 21, 22, 23));
  for (const PlannedUnit& unit : measured.units) EXPECT_GT(unit.cpu_seconds.value_or(0.0), 0.0);
  EXPECT_GT(measured.costs->peak_memory_bytes, 1u << 20);
  RenderParams paths = job("teapot", "out", film), interpolated = paths;
  paths.sampling.integrator = Integrator::kPath;
  EXPECT_EQ(plan_units(ResolvedJob(paths), 9, false, context_).segment, 1);
  interpolated.reuse.choice = ReuseChoice::kInterpolate, interpolated.reuse.keyframes = 16;
  const UnitPlan listed = plan_units(ResolvedJob(interpolated), 9, false, context_);
  EXPECT_EQ(listed.segment, 16);
  ASSERT_EQ(listed.units.size(), 2u);
  EXPECT_THAT(listed.units[0].frames, ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
  EXPECT_FALSE(listed.units[0].cpu_seconds);
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace lippmann::test
