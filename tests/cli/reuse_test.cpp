// Interpolated animations through the command line: which frames are traced, and that neither threads, nor parts, nor
// interruptions change them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

Words interpolated(const std::string& frames, const std::string& folder, const Words& more = {}) {
  return small_teapot(frames, folder) + Words{"--reuse", "forward", "--keyframes", "4"} + more;
}

TEST(Reuse, key_frames_are_the_traced_ones_and_the_others_are_made_between_them) {
  const TempDir dir;
  const Files traced = rendered(dir, small_teapot("0-8", "traced"), "traced");
  const Json report = report_of(dir, interpolated("0-8", "made"));
  const Files made = files_in(dir / "made", ".png");
  ASSERT_EQ(report["frames"].size(), 9u);
  std::size_t different = 0;
  for (int frame = 0; frame <= 8; ++frame) {
    const std::string name = "frame_000" + std::to_string(frame) + ".png";
    const Json& figures = report["frames"][static_cast<std::size_t>(frame)];
    if (frame % 4 == 0) {
      EXPECT_EQ(figures["kind"], "key");
      EXPECT_EQ(made.at(name), traced.at(name)) << name;
    } else {
      EXPECT_EQ(figures["kind"], "in-between");
      EXPECT_EQ(figures["rays"]["primary"], 0);
      EXPECT_EQ(figures["reused_pixels"].get<int>() + figures["missed_pixels"].get<int>(), 128 * 128);
      EXPECT_EQ(figures["newly_visible_pixels"].get<int>() + figures["not_covered_pixels"].get<int>(),
                figures["missed_pixels"]);
      different += made.at(name) != traced.at(name);
    }
  }
  EXPECT_GT(different, 0u);
  EXPECT_EQ(report["totals"]["source_frames"], 0);
}

TEST(Reuse, any_thread_count_gives_the_same_bytes) {
  const TempDir dir;
  const Files one = rendered(dir, interpolated("0-4", "one", {"--threads", "1"}), "one");
  EXPECT_EQ(rendered(dir, interpolated("0-4", "four", {"--threads", "4"}), "four"), one);
}

TEST(Reuse, frames_of_a_part_are_those_of_the_whole_and_count_their_sources) {
  const TempDir dir;
  // Frame 3 comes from 0 and 4, frame 5 from 4 and 8; by halving from 2 and 4, and from 4 and 6.
  const std::vector<std::pair<Words, int>> ways{{{"--fill", "interpolate"}, 2}, {{"--fill", "retrace", "--halving"}, 4}};
  for (const auto& [how, sources] : ways) {
    const Files whole = rendered(dir, interpolated("0-8", "whole", how), "whole");
    const Json report = report_of(dir, interpolated("3-5", "part", how));
    for (const auto& [name, bytes] : files_in(dir / "part", ".png")) EXPECT_EQ(bytes, whole.at(name)) << name << how[1];
    EXPECT_EQ(report["frames"].size(), 3u);
    EXPECT_EQ(report["totals"]["source_frames"], sources);
    EXPECT_GE(report["totals"]["rays"]["primary"], 3 * 128 * 128);
    std::filesystem::remove_all(dir / "whole");
    std::filesystem::remove_all(dir / "part");
  }
}

TEST(Reuse, frames_that_are_missing_are_made_again_to_the_same_bytes_on_resume) {
  const TempDir dir;
  const Files whole = rendered(dir, interpolated("0-9", "a", {"--fill", "retrace", "--halving"}), "a");
  for (const char* lost : {"3", "4", "9"}) std::filesystem::remove(dir / "a" / ("frame_000" + std::string(lost) + ".png"));
  const RunResult resumed =
      run_tool(dir, interpolated("0-9", "a", {"--fill", "retrace", "--halving", "--resume", "--verbose"}));
  EXPECT_EQ(frames_said(resumed.err), 3u) << resumed.err;
  EXPECT_EQ(files_in(dir / "a", ".png"), whole);
}

TEST(Reuse, another_interval_is_another_render_of_which_no_frame_is_kept) {
  const TempDir dir;
  rendered(dir, interpolated("0-4", "a"), "a");
  const Words shorter = small_teapot("0-4", "a") + Words{"--reuse", "forward", "--keyframes", "2", "--resume", "--verbose"};
  expect_refusal(run_tool(dir, shorter), 1, "a: holds another render: it differs in keyframes");
  const RunResult other = run_tool(dir, shorter + Words{"--force"});
  EXPECT_EQ(frames_said(other.err), 5u) << other.err;
}

/// Frame 8 between 0 and 16, when the gears have turned so far that pixels are missed.
Words turned_gears(const std::string& folder, const Words& more) {
  return Words{"render", "gears", "--lenses", "16", "--frames", "8", "--output", folder} + more;
}
const Words kSixteen{"--reuse", "forward", "--keyframes", "16"};

TEST(Reuse, retracing_missed_pixels_brings_the_frame_nearer_to_the_traced_one) {
  const TempDir dir;
  rendered(dir, turned_gears("traced", {}), "traced");
  rendered(dir, turned_gears("filled", kSixteen), "filled");
  const Json report = report_of(dir, turned_gears("retraced", kSixteen + Words{"--fill", "retrace"}));
  const auto mse = [&](const char* folder) {
    return json_of(run_tool(dir, {"compare", "traced", folder, "--json"}).out)["mean"]["mse"]["mean"].get<double>();
  };
  EXPECT_LT(mse("retraced"), mse("filled"));
  const Json& frame = report["frames"][0];
  EXPECT_GT(frame["missed_pixels"], 0);
  EXPECT_EQ(frame["retraced_pixels"], frame["missed_pixels"]);
  EXPECT_EQ(frame["rays"]["primary"], frame["missed_pixels"]);
}

TEST(Reuse, pictures_for_looking_at_differ_from_the_good_one) {
  const TempDir dir;
  const Files good = rendered(dir, turned_gears("good", kSixteen), "good");
  for (const Words& how : {Words{"--debug", "missed"}, Words{"--no-z-buffer"}, Words{"--splat", "lens"}})
    EXPECT_TRUE(rendered(dir, turned_gears(how[0], kSixteen + how), how[0]) != good) << how[0];
}

TEST(Reuse, halving_makes_the_middle_frame_as_without_and_others_from_it) {
  const TempDir dir;
  const Files keys_only = rendered(dir, interpolated("0-4", "keys"), "keys");
  const Files halved = rendered(dir, interpolated("0-4", "halved", {"--halving"}), "halved");
  EXPECT_TRUE(halved.at("frame_0002.png") == keys_only.at("frame_0002.png"));
  EXPECT_FALSE(halved.at("frame_0001.png") == keys_only.at("frame_0001.png"));
  EXPECT_FALSE(halved.at("frame_0003.png") == keys_only.at("frame_0003.png"));
}

TEST(Reuse, summary_says_what_was_missed_and_why) {
  const TempDir dir;
  const RunResult result = run_tool(dir, interpolated("0-4", "a", {"--verbose"}));
  EXPECT_THAT(result.out, HasSubstr("3 frames made between 2 sources"));
  EXPECT_THAT(result.out, HasSubstr("not covered"));
  EXPECT_THAT(result.err, HasSubstr("between key frames"));
}

TEST(Reuse, every_kind_of_optics_is_interpolated) {
  const TempDir dir;
  for (const Words& optics :
       {Words{"--size", "90x50", "--lens-pixels", "13.776", "--slant", "-9.46"},
        Words{"--optics", "microlens", "--lenses", "10x6", "--lens-pixels", "5"},
        Words{"--optics", "microlens", "--packing", "hexagonal", "--lenses", "10"},
        Words{"--optics", "multiview", "--views", "3x2", "--size", "60x40"}, Words{"--optics", "single", "--size", "33x21"}}) {
    const Json report =
        report_of(dir, Words{"render", "teapot", "--frames", "2", "--reuse", "forward", "--keyframes", "4"} + optics);
    const Json& frame = report["frames"][0];
    EXPECT_EQ(frame["kind"], "in-between");
    const int pixels = report["optics"]["width"].get<int>() * report["optics"]["height"].get<int>();
    EXPECT_GT(frame["reused_pixels"].get<int>(), pixels * 8 / 10) << optics[1];
  }
}

TEST(Reuse, exact_frames_are_those_that_are_traced_whatever_the_keys) {
  const TempDir dir;
  const Files traced = rendered(dir, small_teapot("3-12", "traced") + Words{"--reuse", "none"}, "traced");
  EXPECT_EQ(rendered(dir, small_teapot("3-12", "auto"), "auto"), traced);
  const Json report =
      report_of(dir, small_teapot("3-12", "keys") + Words{"--reuse", "exact", "--keyframes", "4", "--threads", "3"});
  EXPECT_EQ(files_in(dir / "keys", ".png"), traced);
  for (std::size_t i = 0; i < 10; ++i) {
    const Json& frame = report["frames"][i];
    EXPECT_EQ(frame["kind"], i % 4 == 0 ? "key" : "in-between");
    EXPECT_EQ(frame["reused_pixels"].get<int>() + frame["rays"]["primary"].get<int>(), 128 * 128);
  }
}

TEST(Reuse, exact_frames_with_many_samples_are_those_that_are_traced) {
  const TempDir dir;
  const Words samples{"--spp", "4", "--lens-pixels", "7.3"};
  const Files traced = rendered(dir, small_teapot("0-3", "traced") + samples + Words{"--reuse", "none"}, "traced");
  EXPECT_EQ(rendered(dir, small_teapot("0-3", "exact") + samples + Words{"--keyframes", "4"}, "exact"), traced);
}

TEST(Reuse, extra_layers_with_exact_reuse_are_of_every_frame) {
  const TempDir dir;
  const Words layers{"--format", "exr", "--aov", "depth"};
  ASSERT_EQ(run_tool(dir, small_teapot("0-1", "exact") + layers).exit_code, 0);
  ASSERT_EQ(run_tool(dir, small_teapot("0-1", "none") + layers + Words{"--reuse", "none"}).exit_code, 0);
  EXPECT_EQ(files_in(dir / "exact", ".exr"), files_in(dir / "none", ".exr"));
}

TEST(Reuse, combinations_that_mean_nothing_are_refused_before_anything_is_written) {
  const TempDir dir;
  const std::vector<std::pair<Words, std::string>> cases{
      {{"--splat", "lens"}, "--splat"},
      {{"--fill", "retrace"}, "--fill"},
      {{"--no-z-buffer"}, "--no-z-buffer"},
      {{"--debug", "missed"}, "--debug"},
      {{"--halving"}, "--halving"},
      {{"--reuse", "none", "--keyframes", "4"}, "--keyframes"},
      {{"--reuse", "forward", "--keyframes", "1"}, "--keyframes"},
      {{"--reuse", "backward"}, "--reuse"},
      {{"--reuse", "forward", "--aov", "depth"}, "--aov"},
      {{"--reuse", "forward", "--debug", "missed", "--fill", "retrace"}, "--fill"}};
  for (const auto& [flags, named] : cases) {
    expect_refusal(run_tool(dir, small_teapot("0", "a") + flags), 2, named);
    EXPECT_FALSE(std::filesystem::exists(dir / "a")) << named;
  }
}

}  // namespace
}  // namespace lippmann::test
