// A strip holds some rows of a frame. Joined strips must equal a frame rendered as a whole.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "core/frame_ranges.hpp"
#include "distribute/ranks.hpp"
#include "job/finish_animation.hpp"
#include "job/renders.hpp"
#include "job/unit_plan.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class StripRenders : public Renders {
 protected:
  /// Frames have 184 rows: 11 bands of 16 rows and one of 8.
  RenderParams still(const std::string& folder, const Settings& settings = {}) const {
    return job("primitives", folder, Settings{{"size", "64x184"}, {"lenses", "8x23"}, {"frames", "3"}} + settings);
  }

  void render_unit(RenderParams params, int unit, int count) const {
    Context context;
    context.threads = 1;
    params.resume = true;
    render_animation(ResolvedJob(params), context, {}, {.units = Units{{unit}, count}});
  }

  FinishedAnimation finish(const std::string& folder, const std::vector<fs::path>& join = {}) const {
    return finish_animation(dir_ / folder, join, context_);
  }

  Files pictures(const std::string& folder) const { return pictures_below(dir_ / folder); }
};

const std::vector<Settings>& kinds() {
  static const std::vector<Settings> all{
      {},
      {{"spp", "4"}, {"aov", "depth"}, {"format", "exr"}, {"exr-pixels", "float"}},
      {{"optics", "multiview"}, {"views", "2x4"}, {"size", "64x160"}, {"lenses", "0"}, {"layout", "views"}},
      {{"optics", "microlens"}, {"size", "64x184"}, {"lenses", "8x23"}, {"aov", "normal"}, {"transparent", "true"}},
      {{"slant", "12"}, {"lens-pixels", "4.5"}, {"lenses", "0"}},
      {{"aov", "provenance"}},
      {{"integrator", "path"}, {"spp", "4"}, {"aov", "motion"}, {"precompensate", "true"}, {"crosstalk", "0.4"}},
      {{"integrator", "path"}, {"spp", "2"}, {"denoise", "none"}},
      {{"integrator", "path"}, {"spp", "2"}, {"slant", "12"}, {"lens-pixels", "4.5"}, {"lenses", "0"}}};
  return all;
}

TEST_F(StripRenders, strips_have_the_bytes_of_whole_frames) {
  for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
    SCOPED_TRACE(kind);
    Settings settings = kinds()[kind];
    std::erase_if(settings, [](const auto& setting) { return setting.second == "0"; });
    const bool has_lenses = settings.size() == kinds()[kind].size();
    const auto params = [&](const std::string& folder, const std::string& strips) {
      const Settings size = has_lenses ? Settings{{"size", "64x184"}, {"lenses", "8x23"}} : Settings{{"size", "64x160"}};
      return job("primitives", folder, size + settings + Settings{{"frames", "3"}, {"strips", strips}});
    };
    const std::string name = std::to_string(kind);
    render(params(name + "-whole", "1"));
    ASSERT_FALSE(pictures(name + "-whole").empty());
    for (const char* strips : {"2", "3", "5"}) {
      const std::string folder = name + "-in-" + strips;
      const RenderReport report = render(params(folder, strips));
      ASSERT_EQ(report.frames.size(), 1u);
      EXPECT_EQ(report.frames[0].frame, 3);
      EXPECT_TRUE(pictures(folder) == pictures(name + "-whole")) << strips << " strips";
      EXPECT_TRUE(check(folder).passed());
    }
  }
}

TEST_F(StripRenders, units_have_the_bytes_of_one_run) {
  render(still("whole"));
  for (const int count : {2, 3, 8}) {
    const std::string folder = "in-" + std::to_string(count);
    for (int unit = count; unit >= 1; --unit) render_unit(still(folder, {{"strips", "8"}}), unit, count);
    EXPECT_THAT(files_in(dir_ / folder, ".png"), IsEmpty());
    EXPECT_EQ(files_in(dir_ / folder, ".exr").size(), 8u);
    EXPECT_THAT(check(folder).joinable, ElementsAre(3));
    ASSERT_TRUE(finish(folder).report);
    EXPECT_TRUE(pictures(folder) == pictures("whole")) << "and no strip is left";
    EXPECT_TRUE(check(folder).passed());
    EXPECT_TRUE(finish(folder).report) << "a second time";
    const auto report = nlohmann::json::parse(bytes(folder + "/report.json"));
    EXPECT_EQ(report["frames"].size(), 1u);
    EXPECT_EQ(report["frames"][0]["rays"]["primary"], 64 * 184);
    EXPECT_EQ(report["interrupted"], false);
    EXPECT_EQ(report["runs"].size(), static_cast<std::size_t>(count) + 2);
    // runs that began in the same second may be in any order
    std::vector<std::string> strips;
    for (const auto& run : report["runs"])
      if (run.contains("strips")) strips.push_back(run.at("strips").at("3").get<std::string>());
    EXPECT_EQ(strips.size(), static_cast<std::size_t>(count));
    EXPECT_THAT(strips, testing::Contains(testing::StartsWith("0")));
  }
}

TEST_F(StripRenders, animation_and_video_have_the_same_bytes) {
  const auto film = [&](const std::string& folder, const char* strips) {
    return still(folder, {{"frames", "2-4"}, {"strips", strips}, {"video", dir_ / (folder + ".mkv")}});
  };
  render(film("whole", "1"));
  render(film("one", "2"));
  for (const int unit : {1, 2}) render_unit(film("units", "2"), unit, 2);
  EXPECT_FALSE(exists("units.mkv"));
  ASSERT_TRUE(finish("units").report);
  for (const std::string folder : {"one", "units"}) {
    EXPECT_TRUE(pictures(folder) == pictures("whole")) << folder;
    EXPECT_EQ(bytes(folder + ".mkv"), bytes("whole.mkv")) << folder;
  }
}

TEST_F(StripRenders, missing_strips_are_named_and_resumed) {
  const Settings layer{{"aov", "provenance"}};
  const RenderParams params = still("a", layer + Settings{{"strips", "6"}});
  render(still("whole", layer));
  render_unit(params, 1, 2);
  EXPECT_THAT(check("a").unfinished, ElementsAre(3));
  EXPECT_THAT(check("a").strips_left.at(3), ElementsAre(3, 4, 5));
  EXPECT_THAT(finish("a").to_render, ElementsAre(3));
  render_unit(params, 2, 2);
  fs::resize_file(dir_ / "a/strip_0003_001.exr", 10);
  const FinishedAnimation damaged = finish("a");
  EXPECT_FALSE(damaged.report);
  EXPECT_THAT(damaged.check.damaged, ElementsAre("strip_0003_001.exr"));
  EXPECT_THAT(damaged.to_render, ElementsAre(3));
  const RenderReport resumed = resume(job_of("a"));
  EXPECT_THAT(resumed.run.strips.at(3), ElementsAre(1));
  EXPECT_TRUE(check("a").passed());
  EXPECT_TRUE(pictures("a") == pictures("whole"));
  EXPECT_EQ(kept(resume(job_of("a"))), 1u);
}

TEST_F(StripRenders, damaged_frame_is_rendered_again) {
  render(still("a", {{"strips", "3"}}));
  const Files whole = pictures("a");
  fs::resize_file(dir_ / "a/frame_0003.png", 10);
  EXPECT_THAT(finish("a").to_render, ElementsAre(3));
  render_unit(still("a", {{"strips", "3"}}), 1, 1);
  EXPECT_EQ(files_in(dir_ / "a", ".exr").size(), 3u);
  ASSERT_TRUE(finish("a").report) << "joined again";
  EXPECT_TRUE(pictures("a") == whole);
}

TEST_F(StripRenders, strips_of_a_killed_run_are_removed) {
  render(still("a", {{"strips", "3"}}));
  const Files whole = pictures("a");
  std::ofstream(dir_ / "a/strip_0003_001.exr") << "what was being removed";
  EXPECT_TRUE(check("a").passed());
  EXPECT_EQ(kept(resume(job_of("a"))), 1u);
  EXPECT_TRUE(pictures("a") == whole);
}

TEST_F(StripRenders, strips_in_several_folders_are_joined) {
  render(still("whole"));
  for (const int unit : {1, 2}) render_unit(still("part" + std::to_string(unit), {{"strips", "4"}}), unit, 2);
  EXPECT_THAT(finish("all", {dir_ / "part1"}).check.strips_left.at(3), ElementsAre(2, 3));
  ASSERT_TRUE(finish("all", {dir_ / "part1", dir_ / "part2"}).report);
  EXPECT_TRUE(pictures("all") == pictures("whole"));
  EXPECT_EQ(files_in(dir_ / "part1", ".exr").size(), 2u) << "parts stay";
}

/// The first of two MPI processes. The second stops before it renders.
class RankOfStoppedJob : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 2; }
  void listen(std::function<void(const WorkDone&)>) override {}
  void begin() override {}
  bool has_begun() const override { return true; }
  int next() override { return std::exchange(next_, 1000); }
  void tell(const WorkDone&) override {}
  void end() override {}

 private:
  int next_ = 0;
};

TEST_F(StripRenders, strips_of_a_stopped_rank_remain) {
  const RenderParams params = still("a", {{"strips", "3"}});
  render(params);
  const Files whole = pictures("a");
  RankOfStoppedJob ranks;
  render(params, {.ranks = &ranks});
  EXPECT_EQ(files_in(dir_ / "a", ".exr").size(), 1u) << "nothing is joined";
  EXPECT_EQ(kept(resume(job_of("a"))), 1u);
  EXPECT_TRUE(pictures("a") == whole);
}

TEST_F(StripRenders, strips_belong_to_their_job) {
  render_unit(still("a", {{"strips", "4"}}), 1, 2);
  EXPECT_THAT(refusal(still("a", {{"strips", "2"}})), HasSubstr("holds another render: it differs in strips"));
  render(still("a"), {.force = true});
  EXPECT_THAT(files_in(dir_ / "a", ".exr"), IsEmpty());
  EXPECT_TRUE(check("a").passed());
}

TEST_F(StripRenders, impossible_strips_are_refused) {
  const auto refused = [&](const Settings& settings) { return refusal(still("a", settings)); };
  EXPECT_THAT(error_message([&] { still("a", {{"strips", "0"}}); }), HasSubstr("strips"));
  EXPECT_THAT(
      refused({{"strips", "13"}}),
      HasSubstr("strips: 13 are too many: the picture has 184 rows, of which each strip needs at least 16; accepted: 1 to 12"));
  EXPECT_THAT(refused({{"strips", "2"}, {"reuse", "interpolate"}}),
              HasSubstr("strips: strips are rendered separately, and interpolated"));
  const Settings rows_of_views{{"optics", "multiview"}, {"views", "2x4"}, {"size", "64x160"}};
  EXPECT_THAT(refusal(job("primitives", "a", rows_of_views + Settings{{"strips", "2"}, {"integrator", "path"}})),
              HasSubstr("strips: the denoiser averages views of all rows"));
  EXPECT_FALSE(exists("a"));
}

TEST_F(StripRenders, plan_has_every_strip_once) {
  const RenderParams params = still("out", {{"frames", "3-4"}, {"strips", "4"}});
  const UnitPlan measured = plan_units(ResolvedJob(params), 3, true, context_);
  ASSERT_EQ(measured.units.size(), 3u);
  EXPECT_THAT(measured.units[1].frames, ElementsAre(3, 4));
  std::vector<std::pair<int, int>> all;
  for (const PlannedUnit& unit : measured.units) {
    EXPECT_GT(unit.cpu_seconds.value_or(0.0), 0.0);
    for (const auto& [frame, strips] : unit.strips)
      for (const int strip : strips) all.emplace_back(frame, strip);
  }
  EXPECT_EQ(all.size(), 8u);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()) && std::adjacent_find(all.begin(), all.end()) == all.end());
  EXPECT_GT(measured.join_bytes.value_or(0.0), 64.0 * 184.0 * 12.0);
  EXPECT_EQ(plan_units(ResolvedJob(params), 99, false, context_).units.size(), 8u);
  EXPECT_FALSE(exists("out"));
}

// Tests frames that are rendered in bands of rows because whole frames do not fit into available_memory. `kinds` has the
// available bytes per pixel.
TEST_F(StripRenders, bands_have_the_bytes_of_whole_frames) {
  const std::pair<Settings, double> kinds[] = {{{{"frames", "3-4"}, {"reuse", "copy"}}, 31.0},
                                               {{{"integrator", "path"}, {"spp", "2"}}, 130.0}};
  for (const auto& [settings, bytes_per_pixel] : kinds) {
    render(still("whole", settings), {.force = true});
    EXPECT_THAT(warnings_, Not(HasSubstr("bands of rows")));
    render(still("bands", settings), {.force = true, .available_memory = bytes_per_pixel * 64 * 184});
    EXPECT_THAT(warnings_, HasSubstr("bands of rows, to the same pixels"));
    EXPECT_EQ(pictures("bands"), pictures("whole"));
    EXPECT_THAT(files_in(dir_ / "bands", ".exr"), IsEmpty()) << "no strips";
    EXPECT_EQ(job_of("bands").strips, 1) << "the job is the same wherever it is rendered";
  }
}

TEST_F(StripRenders, too_little_memory_for_bands_is_refused) {
  const auto refusal = [&](const Settings& settings, double bytes_per_pixel) {
    return error_message([&] { render(still("none", settings), {.available_memory = bytes_per_pixel * 64 * 184}); });
  };
  EXPECT_THAT(refusal({}, 10.0), HasSubstr("even in bands of rows"));
  const Settings rows_of_views{{"optics", "multiview"}, {"views", "2x4"}, {"size", "64x160"}, {"integrator", "path"}};
  EXPECT_THAT(error_message([&] { render(job("primitives", "none", rows_of_views), {.available_memory = 50.0 * 64 * 160}); }),
              HasSubstr("are not possible: the denoiser (`denoise`) averages views of all rows"));
  EXPECT_THAT(refusal({{"reuse", "interpolate"}}, 30.0), HasSubstr("interpolated frames (`reuse`) are made from whole ones"));
  EXPECT_THAT(refusal({{"strips", "4"}}, 5.0), HasSubstr("4 of 64x184 pixels need about"));
  EXPECT_FALSE(fs::exists(dir_ / "none"));
}

TEST_F(StripRenders, frames_are_rendered_one_at_a_time) {
  const Settings several{{"frames", "0-3"}};
  render(still("usual", several));
  render(still("short", several), {.available_memory = 42.0 * 64 * 184});
  EXPECT_THAT(warnings_, HasSubstr("each frame is written before the next one is rendered."));
  EXPECT_EQ(pictures("short"), pictures("usual"));
}

}  // namespace
}  // namespace lippmann::test
