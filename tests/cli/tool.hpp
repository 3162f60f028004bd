// Functions for tests of the command-line tool. They run the tool in a folder and inspect its output.
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

/// Returns the parsed JSON. Throws if the text is not JSON.
nlohmann::json json_of(const std::string& text);

/// Runs the tool with --json, which must succeed, and returns the JSON that it prints.
nlohmann::json report_of(const TempDir& dir, const Words& arguments);

std::size_t lines_of(const std::string& text);

/// Returns the number of frames that a render with --verbose reports on stderr.
std::size_t reported_frames(const std::string& err);

/// Waits until another program has made the file. Returns false after a minute.
bool appears(const std::filesystem::path& path);

void expect_done(const TempDir& dir, const Words& arguments);

/// Expects exactly one line on stderr, nothing on stdout, and the exit code `exit_code`.
void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message);

}  // namespace lippmann::test

namespace nlohmann {

/// GoogleTest calls this function to print values in failure messages.
void PrintTo(const json& value, std::ostream* stream);

}  // namespace nlohmann
