// What the tests of the command-line tool share: running it in a folder, and looking at what it left there.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/subprocess.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {

using Words = std::vector<std::string>;

inline Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A small, quick picture: 16 lenses of 8 pixels.
inline Words small_teapot(const std::string& frames, const std::string& folder) {
  return {"render", "teapot", "--lenses", "16", "--frames", frames, "--output", folder};
}

inline Words tool_command(const Words& arguments) { return Words{LIPPMANN_TOOL} + arguments; }

inline RunResult run_tool(const TempDir& dir, const Words& arguments, std::size_t file_size_limit = 0) {
  return run(tool_command(arguments), {dir.path().string(), file_size_limit});
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

using Files = std::map<std::string, std::string>;  ///< contents by name

/// The files in a folder that end so.
inline Files files_in(const std::filesystem::path& folder, const std::string& ending) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending) files[entry.path().filename().string()] = bytes_of(entry.path());
  return files;
}

/// Runs the tool, which must not fail; the pictures that are then in the folder.
inline Files rendered(const TempDir& dir, const Words& arguments, const std::string& folder) {
  const RunResult result = run_tool(dir, arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return files_in(dir / folder, ".png");
}

/// The same with --json: what it printed.
inline nlohmann::json report_of(const TempDir& dir, const Words& arguments) {
  const RunResult result = run_tool(dir, arguments + Words{"--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return nlohmann::json::parse(result.out);
}

inline std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Waits for a file that a running program is to make; false after a minute.
inline bool appears(const std::filesystem::path& path) {
  for (int i = 0; i < 6000 && !std::filesystem::exists(path); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return std::filesystem::exists(path);
}

/// One message of one line on stderr, nothing on stdout, and that exit code.
inline void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(lines_of(result.err), 1u) << result.err;
  EXPECT_NE(result.err.find(part_of_message), std::string::npos) << result.err;
}

}  // namespace lippmann::test
