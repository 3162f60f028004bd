// What the tool says of light: how much is shared, which lamps shine, how many samples were taken.
#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

Words small_paths(const std::string& folder) {
  return {"render", "teapot", "--lenses", "8", "--integrator", "path", "--spp", "2", "--frames", "0-1", "--output", folder};
}

/// As small_paths, with enough samples for soft light to be shared, which in so small a picture pays in a room.
Words small_shared(const std::string& folder, const std::string& frames) {
  return {"render", "room", "--full-depth", "--lenses", "16",       "--integrator", "path",
          "--spp",  "64",   "--frames",     frames,     "--output", folder};
}

TEST(Light, frames_that_are_traced_although_light_could_be_shared_say_so) {
  const TempDir dir;
  const Words few_lenses{"render", "teapot",   "--lenses", "4",  "--integrator", "path",  "--spp",
                         "8",      "--frames", "0",        "-o", "out",          "--aov", "direct"};
  EXPECT_THAT(run_tool(dir, few_lenses).err, HasSubstr("no light is shared"));
}

// 70 dB are an error of 0.08 codes, which is less than cells are known to, and than 64 times as many paths reach.
TEST(Light, the_summary_warns_of_frames_that_may_fall_short_of_a_floor) {
  const TempDir dir;
  const Words traced{"render", "teapot",   "--lenses", "4",          "--integrator", "path",     "--spp",
                     "8",      "--frames", "0-1",      "--min-psnr", "70",           "--output", "out"};
  const std::string summary = run_tool(dir, traced).out;
  EXPECT_THAT(summary, HasSubstr("every frame was traced in full; estimated PSNR "));
  EXPECT_THAT(summary,
              HasSubstr("  warning   frames 0, 1 may be below --min-psnr 70 (at 95 % confidence); 2 estimates are below it"));
}

TEST(Light, the_summary_says_how_many_frames_share_light) {
  const TempDir dir;
  const RunResult shared = run_tool(dir, small_shared("shared", "0-1"));
  EXPECT_THAT(shared.out, HasSubstr("of 2 frames share light; estimated PSNR "));
  EXPECT_THAT(shared.out, HasSubstr("dB on average, "));
  EXPECT_THAT(shared.out, HasSubstr("dB at worst (frame "));
  EXPECT_THAT(shared.out, testing::Not(HasSubstr("key frames")));
  EXPECT_THAT(run_tool(dir, small_paths("traced")).out, HasSubstr("every frame was traced in full"));
}

/// A triangle: little work for any integrator.
void write_triangle(const std::filesystem::path& path) { std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; }

TEST(Light, summary_report_and_info_say_which_light_was_taken) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const std::string expected = "The built-in studio lights the scene, because the file has no lamps and no surroundings.";
  const Words command{"render", "plain.obj", "--lenses", "4", "--integrator", "path", "--spp", "2", "--output", "out"};
  const RunResult result = run_tool(dir, command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("light     " + expected));
  EXPECT_EQ(json_of(bytes_of(dir / "out/report.json"))["light"], expected);
  EXPECT_EQ(json_of(run_tool(dir, {"info", "plain.obj", "--integrator", "path", "--json"}).out)["light"], expected);
  EXPECT_THAT(run_tool(dir, {"info", "plain.obj", "--integrator", "path", "--environment", "none"}).out,
              HasSubstr("The scene has its own light alone, as --environment none asks for."));
}

TEST(Light, the_summary_says_how_many_samples_were_taken_and_what_makes_less_noise) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const auto summary = [&](const Words& flags) {
    return run_tool(dir, Words{"render", "plain.obj", "--lenses", "4", "--frames", "0"} + flags).out;
  };
  EXPECT_THAT(summary({}),
              HasSubstr("path traced with 16 samples a pixel; --denoise takes their noise out, --spp 64 lessens it\n"));
  EXPECT_THAT(summary({"--denoise"}), HasSubstr("path traced with 16 samples a pixel, denoised; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--shutter", "0.5"}), HasSubstr("path traced with 16 samples a pixel; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--spp", "1"}), HasSubstr("path traced with 1 sample a pixel; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--spp", "64"}), HasSubstr("path traced with 64 samples a pixel\n"));
  EXPECT_THAT(summary({"--integrator", "whitted"}), testing::Not(HasSubstr("path traced")));
}

}  // namespace
}  // namespace lippmann::test
