// Runs the command-line tool in a folder and inspects its output.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/folder_files.hpp"
#include "support/subprocess.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b);

/// Returns the arguments of a fast render with 16 lenses of 8 pixels each.
Words small_teapot(const std::string& frames, const std::string& folder);

Words tool_command(const Words& arguments);

RunResult run_tool(const TempDir& dir, const Words& arguments, std::size_t file_size_limit = 0);

std::string bytes_of(const std::filesystem::path& path);

/// Runs the tool, which must succeed, and returns the pictures in `folder`.
Files rendered(const TempDir& dir, const Words& arguments, const std::string& folder);

nlohmann::json json_of(const std::string& text);

/// Runs the tool with --json, which must succeed, and returns the printed JSON.
nlohmann::json report_of(const TempDir& dir, const Words& arguments);

std::size_t lines_of(const std::string& text);

/// Counts the frames that `render --verbose` reports on stderr.
std::size_t reported_frames(const std::string& err);

/// Waits up to a minute for the file. Returns whether it exists.
bool appears(const std::filesystem::path& path);

void expect_done(const TempDir& dir, const Words& arguments);

/// Expects the exit code, one line on stderr and nothing on stdout.
void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message);

}  // namespace lippmann::test

namespace nlohmann {

/// GoogleTest prints values in failure messages with this function.
void PrintTo(const json& value, std::ostream* stream);

}  // namespace nlohmann
