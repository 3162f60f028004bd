#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

/// Runs a shell script in which "$0" "$@" is the tool's command.
RunResult run_script(const TempDir& dir, const std::string& script, const Words& arguments) {
  return run(Words{"/bin/sh", "-c", script} + tool_command(arguments), {dir.path().string(), 0});
}

std::string code_in(const TempDir& dir) {
  std::ifstream file(dir / "code");
  std::string code;
  file >> code;
  return code;
}

TEST(Streams, render_succeeds_with_closed_streams) {
  const TempDir dir;
  const RunResult result = run_script(dir, "exec \"$0\" \"$@\" <&- >&- 2>&-", small_teapot("0-1", "a") + Words{"--verbose"});
  EXPECT_EQ(result.exit_code, 0);
  expect_done(dir, {"check", "a"});
}

TEST(Streams, refusal_keeps_its_exit_code) {
  const TempDir dir;
  EXPECT_EQ(run_script(dir, "exec \"$0\" \"$@\" <&- >&- 2>&-", {"check", "missing"}).exit_code, 1);
  EXPECT_EQ(run_script(dir, "exec \"$0\" \"$@\" <&- >&- 2>&-", {"render", "--no-such-flag"}).exit_code, 2);
}

const std::string kUntilNobodyReads = "(while echo; do :; done) 2>/dev/null";

TEST(Streams, render_survives_a_closed_progress_pipe) {
  const TempDir dir;
  run_script(dir, "{ " + kUntilNobodyReads + "; \"$0\" \"$@\" 2>&1 >/dev/null; echo $? > code; } | true",
             small_teapot("0-3", "a") + Words{"--verbose"});
  EXPECT_EQ(code_in(dir), "0");
  expect_done(dir, {"check", "a"});
}

TEST(Streams, closed_report_pipe_is_an_error) {
  const TempDir dir;
  run_script(dir, "{ " + kUntilNobodyReads + "; \"$0\" \"$@\" 2>err; echo $? > code; } | true",
             small_teapot("0-1", "a") + Words{"--json", "--also", "single"});
  EXPECT_EQ(code_in(dir), "1");
  EXPECT_THAT(bytes_of(dir / "err"), testing::HasSubstr("standard output: cannot be written"));
  expect_done(dir, {"check", "a"});
  EXPECT_TRUE(fs::exists(dir / "a/single/frame_0001.png"));
}

}  // namespace
}  // namespace lippmann::test
