// Interpolated animations that keep to a PSNR: that they do, and that nothing but what is asked for changes their bytes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using Json = nlohmann::json;

Words floored(const std::string& scene, const std::string& frames, const std::string& folder, const Words& more = {}) {
  return Words{"render", scene, "--lenses", "16", "--frames", frames, "--output", folder, "--reuse", "forward"} + more;
}

/// Of the frames that are predicted: those that are traced as a whole keep any floor.
TEST(Floor, is_kept_by_nineteen_predicted_frames_of_twenty_over_all_scenes) {
  const TempDir dir;
  int predicted = 0, kept = 0;
  for (const std::string scene : {"teapot", "room", "small-balls", "primitives", "tree", "gears"}) {
    const auto render = [&](const std::string& folder, const Words& how) {
      return report_of(dir, Words{"render", scene, "--lenses", "32", "--frames", "40-48", "--output", folder} + how);
    };
    render(scene, {"--reuse", "none"});
    for (const std::string floor : {"32", "38"}) {
      const std::string folder = scene + floor;
      const Json report = render(folder, {"--reuse", "forward", "--min-psnr", floor});
      const Json likeness = json_of(run_tool(dir, {"compare", scene, folder, "--json"}).out);
      for (std::size_t i = 0; i < 9; ++i) {
        const Json &psnr = likeness["frames"][i]["psnr_db"], &figures = report["frames"][i];
        if (figures["kind"] != "in-between") {
          EXPECT_TRUE(psnr.is_null()) << scene << floor << " frame " << i;
          EXPECT_TRUE(figures["estimated_psnr_db"].is_null());
          continue;
        }
        ++predicted;
        kept += psnr.is_null() || psnr.get<double>() >= std::stod(floor);
        EXPECT_GE(figures["psnr_at_least_db"].get<double>(), std::stod(floor));
        EXPECT_GE(figures["estimated_psnr_db"], figures["psnr_at_least_db"]);
      }
    }
  }
  EXPECT_GT(predicted, 50);  // else nothing has been tested
  EXPECT_GE(100 * kept, 95 * predicted) << kept << " of " << predicted;
  RecordProperty("predicted", predicted);
  RecordProperty("kept", kept);
}

TEST(Floor, any_thread_count_gives_the_same_bytes) {
  const TempDir dir;
  const Files one = rendered(dir, floored("gears", "0-8", "one", {"--min-psnr", "45", "--threads", "1"}), "one");
  EXPECT_EQ(one.size(), 9u);
  EXPECT_EQ(rendered(dir, floored("gears", "0-8", "two", {"--min-psnr", "45", "--threads", "2"}), "two"), one);
  EXPECT_EQ(rendered(dir, floored("gears", "0-8", "four", {"--min-psnr", "45", "--threads", "4"}), "four"), one);
}

TEST(Floor, frames_of_a_part_and_those_made_again_are_those_of_the_whole) {
  const TempDir dir;
  for (const char* floor : {"35", "50"}) {  // few and many intervals that are halved
    const Words wanted{"--min-psnr", floor};
    const std::string whole_folder = std::string("whole") + floor, part_folder = std::string("part") + floor;
    const Files whole = rendered(dir, floored("gears", "0-9", whole_folder, wanted), whole_folder);
    for (const char* part : {"1-2", "5-6", "7-7"})
      for (const auto& [name, bytes] : rendered(dir, floored("gears", part, part_folder + part, wanted), part_folder + part))
        EXPECT_EQ(bytes, whole.at(name)) << name << " of " << part;
    for (const char* lost : {"3", "4", "9"})
      std::filesystem::remove(dir / whole_folder / ("frame_000" + std::string(lost) + ".png"));
    const RunResult resumed = run_tool(dir, floored("gears", "0-9", whole_folder, wanted + Words{"--resume", "--verbose"}));
    EXPECT_EQ(frames_said(resumed.err), 3u) << resumed.err;
    EXPECT_EQ(files_in(dir / whole_folder, ".png"), whole);
  }
}

TEST(Floor, where_nothing_pays_every_frame_is_traced_once_and_nothing_more) {
  const TempDir dir;
  const Words every_frame{"render", "gears", "--lenses", "16", "--frames", "0-20"};
  const Json report = report_of(dir, every_frame + Words{"--output", "a", "--reuse", "forward", "--min-psnr", "70"});
  std::uint64_t rays = 0;
  for (const Json& frame : report["frames"]) {
    EXPECT_NE(frame["kind"], "in-between");
    rays += frame["rays"]["primary"].get<std::uint64_t>();
  }
  EXPECT_EQ(rays, 21u * 128 * 128);
  EXPECT_TRUE(!report.contains("source_frames") || report["source_frames"].empty());
  const Files traced = rendered(dir, every_frame + Words{"--output", "b", "--reuse", "none"}, "b");
  EXPECT_EQ(files_in(dir / "a", ".png"), traced);
}

TEST(Floor, keys_asked_for_stay_and_pixels_are_either_traced_or_reused) {
  const TempDir dir;
  const Json report = report_of(dir, floored("teapot", "0-4", "a", {"--min-psnr", "30", "--keyframes", "2"}));
  for (std::size_t i = 0; i < 5; ++i) {
    const Json& frame = report["frames"][i];
    // Frame 1 is learned from.
    EXPECT_EQ(frame["kind"], i % 2 == 0 ? "key" : i == 1 ? "full" : "in-between");
    if (frame["kind"] != "in-between") continue;
    EXPECT_EQ(frame["retraced_pixels"], frame["rays"]["primary"]);
    EXPECT_EQ(frame["retraced_pixels"].get<int>() + frame["reused_pixels"].get<int>(), 128 * 128);
  }
}

TEST(Floor, every_kind_of_optics_keeps_it) {
  const TempDir dir;
  const std::vector<Words> kinds{{"--optics", "microlens"},
                                 {"--optics", "multiview", "--views", "4x2", "--size", "128x128"},
                                 {"--optics", "single", "--size", "96x64"},
                                 {"--slant", "9", "--lens-pixels", "7.5"}};
  for (const Words& kind : kinds) {
    const Words size = kind[1] == "multiview" || kind[1] == "single" ? Words{} : Words{"--lenses", "12"};
    const auto render = [&](const std::string& folder, const Words& how) {
      return run_tool(dir, Words{"render", "teapot", "--frames", "0-2", "--output", folder} + size + kind + how);
    };
    ASSERT_EQ(render("traced", {"--reuse", "none"}).exit_code, 0);
    const RunResult made = render("made", {"--reuse", "forward", "--keyframes", "2", "--min-psnr", "35"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Json psnr = json_of(run_tool(dir, {"compare", "traced", "made", "--json"}).out)["frames"][1]["psnr_db"];
    EXPECT_TRUE(psnr.is_null() || psnr.get<double>() >= 35.0) << kind[1] << ' ' << psnr;
    std::filesystem::remove_all(dir / "traced");
    std::filesystem::remove_all(dir / "made");
  }
}

TEST(Floor, exact_reuse_keeps_any) {
  const TempDir dir;
  const Files traced = rendered(dir, small_teapot("0-1", "traced") + Words{"--reuse", "none"}, "traced");
  EXPECT_EQ(rendered(dir, small_teapot("0-1", "exact") + Words{"--reuse", "exact", "--min-psnr", "50"}, "exact"), traced);
}

TEST(Floor, combinations_that_mean_nothing_are_refused) {
  const TempDir dir;
  const std::vector<std::pair<Words, std::string>> cases{
      {{"--reuse", "none", "--min-psnr", "50"}, "--min-psnr"},
      {{"--reuse", "forward", "--min-psnr", "5"}, "--min-psnr"},
      {{"--reuse", "forward", "--min-psnr", "nan"}, "--min-psnr"},
      {{"--reuse", "forward", "--min-psnr", "50", "--halving"}, "--halving"},
      {{"--reuse", "forward", "--min-psnr", "50", "--debug", "missed"}, "--debug"},
      {{"--reuse", "forward", "--min-psnr", "50", "--fill", "retrace"}, "--fill"},
      {{"--reuse", "forward", "--min-psnr", "50", "--no-z-buffer"}, "--no-z-buffer"},
  };
  for (const auto& [flags, part] : cases) {
    expect_refusal(run_tool(dir, small_teapot("0-1", "out") + flags), 2, part);
    EXPECT_FALSE(std::filesystem::exists(dir / "out"));
  }
}

}  // namespace
}  // namespace lippmann::test
