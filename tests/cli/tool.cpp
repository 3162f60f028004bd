#include "cli/tool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <ostream>
#include <thread>

namespace lippmann::test {

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Words small_teapot(const std::string& frames, const std::string& folder) {
  return {"render", "teapot", "--lenses", "16", "--frames", frames, "--output", folder};
}

Words tool_command(const Words& arguments) { return Words{LIPPMANN_TOOL} + arguments; }

RunResult run_tool(const TempDir& dir, const Words& arguments, std::size_t file_size_limit) {
  return run(tool_command(arguments), {dir.path().string(), file_size_limit});
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

Files rendered(const TempDir& dir, const Words& arguments, const std::string& folder) {
  const RunResult result = run_tool(dir, arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return files_in(dir / folder, ".png");
}

nlohmann::json json_of(const std::string& text) { return nlohmann::json::parse(text); }

nlohmann::json report_of(const TempDir& dir, const Words& arguments) {
  const RunResult result = run_tool(dir, arguments + Words{"--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return json_of(result.out);
}

std::size_t lines_of(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

std::size_t reported_frames(const std::string& err) {
  std::istringstream lines(err);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with("[");
  return count;
}

bool appears(const std::filesystem::path& path) {
  for (int i = 0; i < 6000 && !std::filesystem::exists(path); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return std::filesystem::exists(path);
}

void expect_done(const TempDir& dir, const Words& arguments) {
  const RunResult result = run_tool(dir, arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(lines_of(result.err), 1u) << result.err;
  EXPECT_NE(result.err.find(part_of_message), std::string::npos) << result.err;
}

}  // namespace lippmann::test

void nlohmann::PrintTo(const json& value, std::ostream* stream) { *stream << value; }
