// Reuse on the command line: what is said of it, that interruptions change nothing, and what is refused.
#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

Words interpolated(const std::string& frames, const std::string& folder, const Words& more = {}) {
  return small_teapot(frames, folder) + Words{"--reuse", "forward", "--keyframes", "4"} + more;
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

TEST(Reuse, summary_says_what_was_missed_and_why) {
  const TempDir dir;
  const RunResult result = run_tool(dir, interpolated("0-4", "a", {"--verbose"}));
  EXPECT_THAT(result.out, HasSubstr("3 frames made between 2 sources"));
  EXPECT_THAT(result.out, HasSubstr("not covered"));
  EXPECT_THAT(result.err, HasSubstr("between key frames"));
}

TEST(Reuse, combinations_that_mean_nothing_are_refused_before_anything_is_written) {
  const TempDir dir;
  for (const auto& [flags, named] : std::vector<std::pair<Words, std::string>>{
           {{"--splat", "lens"}, "--splat"}, {{"--reuse", "backward"}, "--reuse"}, {{"--min-psnr", "5"}, "--min-psnr"}}) {
    expect_refusal(run_tool(dir, small_teapot("0", "a") + flags), 2, named);
    EXPECT_FALSE(std::filesystem::exists(dir / "a")) << named;
  }
}

}  // namespace
}  // namespace lippmann::test
