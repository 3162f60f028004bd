// `render --denoise` from the command line.
#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

Words small_frames(const std::string& frames, const std::string& folder) {
  return {"render", "teapot",   "--lenses", "8",        "--integrator", "path",     "--spp",
          "4",      "--frames", frames,     "--output", folder,         "--denoise"};
}

TEST(Denoise, report_says_so_and_counts_the_frames_beside) {
  const TempDir dir;
  const nlohmann::json report = report_of(dir, small_frames("1-2", "out"));
  EXPECT_TRUE(report.at("settings").at("denoise").get<bool>());
  EXPECT_EQ(report.at("totals").at("frames"), 2);
  EXPECT_EQ(report.at("totals").at("source_frames"), 2);  // 0 and 3
}

TEST(Denoise, quilts_views_layers_and_alpha_are_made_with_it) {
  const TempDir dir;
  for (const Words& kind : {Words{"--optics", "multiview", "--views", "3x1", "--size", "48x16", "--layout", "quilt"},
                            Words{"--optics", "multiview", "--views", "2x2", "--size", "32x36", "--camera-grid"},
                            Words{"--optics", "microlens", "--lens-pixels", "3", "--layout", "views"},
                            Words{"--optics", "single", "--size", "32x32", "--transparent"},
                            Words{"--format", "exr", "--aov", "albedo,direct,motion"}}) {
    Words command{"render", "room", "--integrator", "path", "--spp", "2", "--frames", "3", "--denoise"};
    if (kind[0] == "--format" || kind[1] == "microlens") command = command + Words{"--lenses", "8"};
    const RunResult result = run_tool(dir, command + kind);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
}

TEST(Denoise, what_cannot_be_denoised_is_refused) {
  const TempDir dir;
  expect_refusal(run_tool(dir, small_teapot("0", "out") + Words{"--denoise"}), 2, "--denoise: only paths have noise");
  const Words one_sample{"render", "teapot", "--lenses", "8", "--integrator", "path", "--spp", "1", "--denoise"};
  expect_refusal(run_tool(dir, one_sample), 2, "--denoise: the noise of one sample");
  expect_refusal(run_tool(dir, small_frames("0", "out") + Words{"--lens-pixels", "7.5"}), 2, "--denoise: lenses that do not");
}

}  // namespace
}  // namespace lippmann::test
