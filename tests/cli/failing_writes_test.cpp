// Fails one system call or allocation after another of a render. The tool must report each failure and leave no
// incomplete file under a final name.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string_view>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

/// Runs the tool while call `number` of the kind `call` fails, and also all later calls if `all_that_follow`.
RunResult run_failing(const TempDir& dir, const Words& arguments, const std::string& call, int number, bool all_that_follow) {
  const std::string failed = dir / "failed";
  return run(Words{"/usr/bin/env", "LD_PRELOAD=" LIPPMANN_FAILING_WRITES, "LIPPMANN_FAIL_CALL=" + call,
                   "LIPPMANN_FAIL_NUMBER=" + std::to_string(number), "LIPPMANN_FAILED=" + failed,
                   all_that_follow ? "LIPPMANN_FAIL_ALL=1" : "LIPPMANN_FAIL_ONE=1"} +
                 tool_command(arguments),
             {dir.path().string(), 0});
}

enum class Fails { kOneWrite, kAllFromThereOn };

/// One thread makes the order of system calls the same in every run.
Words render_of_two_frames(const Words& flags, const std::string& folder) {
  Words words{"render", "primitives", "--size", "16x16", "--frames", "0-1", "--threads", "1", "-o", folder};
  for (const std::string& word : flags) words.push_back(word == "VIDEO" ? folder + "/video.mkv" : word);
  return words;
}

int reported_failures(const std::string& err) {
  std::istringstream lines(err);
  int count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with("lippmann: ");
  return count;
}

Files without_temporary(Files files) {
  std::erase_if(files, [](const auto& file) { return file.first.find(".tmp-") != std::string::npos; });
  return files;
}

void expect_whole_files(const Files& files, const Files& whole, int number) {
  for (const auto& [name, bytes] : files) {
    ASSERT_TRUE(whole.contains(name)) << number << ": " << name;
    EXPECT_TRUE(whole.at(name) == bytes) << number << ": " << name;
  }
}

void expect_resumes(const TempDir& dir, const Words& command, int number) {
  const RunResult resumed = run_tool(dir, command + Words{"--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << number << ": " << resumed.err;
  EXPECT_EQ(run_tool(dir, {"check", "cut"}).exit_code, 0) << number;
}

void expect_error_and_whole_files(const Words& flags, Fails fails = Fails::kOneWrite, const std::string& call = "write") {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "a sanitizer's runtime must be loaded first";
  const TempDir dir;
  const Words command = render_of_two_frames(flags, "cut");
  ASSERT_EQ(run_tool(dir, render_of_two_frames(flags, "whole")).exit_code, 0);
  const Files whole = pictures_below(dir / "whole");
  int number = 0;
  for (bool failed = true; failed; fs::remove_all(dir / "cut"), fs::remove(dir / "failed")) {
    const RunResult result = run_failing(dir, command, call, ++number, fails == Fails::kAllFromThereOn);
    failed = fs::exists(dir / "failed");
    EXPECT_EQ(result.exit_code, failed ? 1 : 0) << number << ": " << result.err;
    EXPECT_EQ(reported_failures(result.err), failed ? 1 : 0) << number << ": " << result.err;
    expect_whole_files(pictures_below(dir / "cut"), whole, number);
    if (failed && (number % 4 == 0 || fs::exists(dir / "cut/video.mkv"))) expect_resumes(dir, command, number);
  }
  EXPECT_GT(number, call == "write" ? 8 : call == "mkdir" ? 1 : 4) << "no " << call << " of the pictures failed";
}

TEST(FailingWrites, pictures_leave_whole_files_or_none) {
  for (const Words& flags : {Words{}, Words{"--format", "tiff"}, Words{"--format", "exr"}, Words{"--layout", "views"},
                             Words{"--optics", "multiview", "--views", "2x2", "--layout", "quilt"}})
    expect_error_and_whole_files(flags);
}

TEST(FailingWrites, layers_leave_whole_files_or_none) {
  for (const Fails fails : {Fails::kOneWrite, Fails::kAllFromThereOn})
    expect_error_and_whole_files({"--format", "png16", "--aov", "depth"}, fails);
}

TEST(FailingWrites, videos_leave_whole_files_or_none) {
  for (const Fails fails : {Fails::kOneWrite, Fails::kAllFromThereOn})
    expect_error_and_whole_files({"--video", "VIDEO"}, fails);
}

TEST(FailingWrites, opening_and_renaming_leave_whole_files) {
  for (const std::string call : {"open", "rename"})
    for (const Words& flags : {Words{"--aov", "depth", "--video", "VIDEO"}, Words{"--layout", "views", "--format", "exr"},
                               Words{"--optics", "multiview", "--views", "2x2", "--layout", "quilt", "--format", "tiff"}})
      expect_error_and_whole_files(flags, Fails::kOneWrite, call);
}

TEST(FailingWrites, folder_errors_are_reported) {
  expect_error_and_whole_files({"--layout", "views"}, Fails::kOneWrite, "mkdir");
}

/// Returns n, so that every n-th allocation is tested, because a render makes tens of thousands.
/// LIPPMANN_ALLOCATION_STEP=1 tests all of them.
int allocation_step(bool has_folder) {
  const char* step = std::getenv("LIPPMANN_ALLOCATION_STEP");
  return step ? std::stoi(step) : has_folder ? 457 : 1999;
}

/// Number of runs with a failed allocation, by how they ended.
struct Ends {
  int with_folder = 0;  ///< failed after they had made their folder
  int reported = 0;     ///< printed one line and exited with code 1
  int ended = 0;        ///< were ended by a signal
};

/// A failed allocation causes a reported error, no error, or an abort. Aborts come from destructors that allocate, and
/// from Embree's threads, which do not check for missing memory.
void expect_error_or_whole_files(const RunResult& result, const Files& files, const Files& whole, int number, Ends& ends) {
  constexpr int kSignals = 128;
  if (result.exit_code > kSignals) {
    // a killed run may leave temporary files, which a resumed render removes
    expect_whole_files(without_temporary(files), whole, number);
    ++ends.ended;
    return;
  }
  expect_whole_files(files, whole, number);
  const int failures = result.exit_code == 0 ? 0 : 1;
  EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << number << ": " << result.exit_code << " " << result.err;
  EXPECT_EQ(reported_failures(result.err), failures) << number << ": " << result.err;
  EXPECT_EQ(result.err.find("on this processor"), std::string::npos) << number << ": " << result.err;
  ends.reported += failures;
  if (failures == 0) {
    EXPECT_EQ(files.size(), whole.size()) << number;
  }
}

Ends ends_of_runs_out_of_memory(const TempDir& dir, const Words& flags, const Files& whole) {
  const Words command = render_of_two_frames(flags, "cut");
  Ends ends;
  bool has_folder = false;
  for (int number = 1;; number += allocation_step(has_folder)) {
    const RunResult result = run_failing(dir, command, "allocate", number, false);
    const bool failed = fs::remove(dir / "failed");
    expect_error_or_whole_files(result, pictures_below(dir / "cut"), whole, number, ends);
    has_folder = fs::exists(dir / "cut/.lippmann");
    ends.with_folder += has_folder && result.exit_code != 0;
    if (has_folder) expect_resumes(dir, command, number);
    fs::remove_all(dir / "cut");
    if (!failed) return ends;
  }
}

TEST(FailingAllocations, failures_leave_a_folder_that_resumes) {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "a sanitizer's runtime has its own allocator";
  const TempDir dir;
  const Words flags{"--video", "VIDEO"};
  ASSERT_EQ(run_tool(dir, render_of_two_frames(flags, "whole")).exit_code, 0);
  const Ends ends = ends_of_runs_out_of_memory(dir, flags, pictures_below(dir / "whole"));
  EXPECT_GT(ends.with_folder, 8);
  EXPECT_LE(4 * ends.ended, ends.reported) << "a few failures may end in a library";
}

TEST(FailingWrites, remaining_strips_are_removed_later) {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "a sanitizer's runtime must be loaded first";
  const TempDir dir;
  const Words command{"render", "primitives", "--size", "64x64", "--frames", "0", "--strips", "2", "-o", "a"};
  const RunResult result = run_failing(dir, command, "remove", 1, true);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("strip_0000_000.exr: cannot be removed"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(dir / "a/strip_0000_000.exr"));
  expect_done(dir, command + Words{"--resume"});
  EXPECT_FALSE(fs::exists(dir / "a/strip_0000_000.exr"));
}

TEST(FailingWrites, undeletable_render_is_not_replaced) {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "a sanitizer's runtime must be loaded first";
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  const RunResult result = run_failing(dir, small_teapot("0", "a") + Words{"--view-angle", "40", "--force"}, "remove", 1, true);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("frame_0000.png: cannot be removed"), std::string::npos) << result.err;
}

TEST(FailingWrites, syncing_leaves_whole_files_or_none) {
  expect_error_and_whole_files({"--video", "VIDEO"}, Fails::kOneWrite, "fsync");
}

}  // namespace
}  // namespace lippmann::test
