// Renders of which one write fails, the first, the second and so on, or all from there on: the tool says so, and no half file
// has a final name.
#include <gtest/gtest.h>

#include <string_view>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

struct Failing {
  Words flags;
  bool all_that_follow = false;
};

/// Runs the tool, of whose writes to files this one fails, and perhaps all that follow.
RunResult run_failing(const TempDir& dir, const Words& arguments, int write, bool all_that_follow) {
  const std::string failed = dir / "failed";
  return run(Words{"/usr/bin/env", "LD_PRELOAD=" LIPPMANN_FAILING_WRITES, "LIPPMANN_FAIL_WRITE=" + std::to_string(write),
                   "LIPPMANN_FAILED=" + failed, all_that_follow ? "LIPPMANN_FAIL_ALL=1" : "LIPPMANN_FAIL_ONE=1"} +
                 tool_command(arguments),
             {dir.path().string(), 0});
}

/// Below the folder, but for those that tell of times; the contents by name.
Files files_below(const fs::path& folder) {
  Files files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (entry.is_regular_file() && name != "report.json" && name != ".lippmann-frames.jsonl" && name != "job.toml")
      files[entry.path().lexically_relative(folder)] = bytes_of(entry.path());
  }
  return files;
}

class FailingWrites : public testing::TestWithParam<Failing> {};

TEST_P(FailingWrites, are_said_and_leave_whole_files_or_none) {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "a sanitizer's run-time wants to be loaded first";
  const TempDir dir;
  const auto command = [&](const std::string& folder) {
    Words words{"render", "teapot", "--size", "48x48", "--frames", "0-1", "-o", folder};
    for (const std::string& word : GetParam().flags) words.push_back(word == "VIDEO" ? folder + "/video.mkv" : word);
    return words;
  };
  ASSERT_EQ(run_tool(dir, command("whole")).exit_code, 0);
  const Files whole = files_below(dir / "whole");
  int write = 0;
  for (bool failed = true; failed; fs::remove_all(dir / "cut"), fs::remove(dir / "failed")) {
    const RunResult result = run_failing(dir, command("cut"), ++write, GetParam().all_that_follow);
    failed = fs::exists(dir / "failed");
    EXPECT_EQ(result.exit_code, failed ? 1 : 0) << write << ": " << result.err;
    for (const auto& [name, bytes] : files_below(dir / "cut")) {
      ASSERT_TRUE(whole.contains(name)) << write << ": " << name;
      EXPECT_TRUE(whole.at(name) == bytes) << write << ": " << name;
    }
    if (failed && (write % 4 == 0 || fs::exists(dir / "cut/video.mkv"))) {
      const RunResult resumed = run_tool(dir, command("cut") + Words{"--resume"});
      EXPECT_EQ(resumed.exit_code, 0) << write << ": " << resumed.err;
      EXPECT_EQ(run_tool(dir, {"check", "cut"}).exit_code, 0) << write;
    }
  }
  EXPECT_GT(write, 8) << "no write of the pictures failed";
}

INSTANTIATE_TEST_SUITE_P(Render, FailingWrites,
                         testing::Values(Failing{{}}, Failing{{"--format", "png16", "--aov", "depth"}},
                                         Failing{{"--format", "png16", "--aov", "depth"}, true}, Failing{{"--format", "tiff"}},
                                         Failing{{"--format", "exr"}}, Failing{{"--layout", "views"}},
                                         Failing{{"--optics", "multiview", "--views", "2x2", "--layout", "quilt"}},
                                         Failing{{"--video", "VIDEO"}}, Failing{{"--video", "VIDEO"}, true}));

}  // namespace
}  // namespace lippmann::test
