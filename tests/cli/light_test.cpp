#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

Words small_paths(const std::string& frames, const std::string& folder) {
  return {"render", "teapot", "--lenses", "8", "--integrator", "path", "--spp", "2", "--frames", frames, "--output", folder};
}

/// Without denoising, 2 samples per pixel give enough noise for a reported error.
Words noisy_paths(const std::string& frames, const std::string& folder) {
  return small_paths(frames, folder) + Words{"--denoise", "none"};
}

TEST(Light, summary_has_the_error_of_paths) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, noisy_paths("0", "one")).out,
              testing::ContainsRegex("estimated error [0-9]+ dB \\([0-9]+ to [0-9]+\\)\n"));
  const RunResult two = run_tool(dir, noisy_paths("0-1", "two"));
  EXPECT_THAT(two.out, testing::ContainsRegex("estimated error at worst [0-9]+ dB \\([0-9]+ to [0-9]+\\), in frame [01]\n"));
  EXPECT_THAT(two.out, HasSubstr("every frame was traced in full"));
}

TEST(Light, report_has_the_errors_interval) {
  const TempDir dir;
  EXPECT_EQ(run_tool(dir, noisy_paths("0-1", "out")).exit_code, 0);
  const nlohmann::json report = json_of(bytes_of(dir / "out/report.json"));
  for (const auto& frame : report["frames"]) {
    EXPECT_EQ(frame["kind"], "full");
    EXPECT_LT(frame["psnr_at_least_db"], frame["estimated_psnr_db"]);
    EXPECT_LT(frame["estimated_psnr_db"], frame["psnr_at_most_db"]);
  }
}

TEST(Light, bare_denoise_is_auto) {
  const TempDir dir;
  const auto pictures = [&](const std::string& folder, const Words& flags) {
    return rendered(dir, small_paths("0", folder) + flags, folder);
  };
  const Files by_default = pictures("a", {}), plain = pictures("b", {"--denoise", "none"});
  EXPECT_NE(by_default, plain);
  EXPECT_EQ(pictures("c", {"--denoise"}), by_default);
  EXPECT_EQ(pictures("d", {"--denoise", "auto"}), by_default);
  EXPECT_EQ(pictures("e", {"--denoise", "--reuse", "none"}), by_default);
  EXPECT_EQ(pictures("f", {"--denoise=none", "--reuse", "none"}), plain);
}

void write_triangle(const std::filesystem::path& path) { std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; }

TEST(Light, chosen_light_is_reported) {
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
              HasSubstr("The scene has only its own light, as requested by --environment none."));
}

TEST(Light, summary_has_samples_and_advice) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const auto summary = [&](const Words& flags) {
    return run_tool(dir, Words{"render", "plain.obj", "--lenses", "4", "--frames", "0"} + flags).out;
  };
  EXPECT_THAT(summary({}), HasSubstr("path traced with 16 samples a pixel, denoised; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--denoise", "none"}), HasSubstr("path traced with 16 samples a pixel; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--spp", "1"}), HasSubstr("path traced with 1 sample a pixel; --spp 4 for less noise\n"));
  EXPECT_THAT(summary({"--integrator", "whitted"}), testing::Not(HasSubstr("path traced")));
}

}  // namespace
}  // namespace lippmann::test
