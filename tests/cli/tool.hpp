// Helpers for tests of the command-line tool: run it in a folder, and inspect its output there.
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

/// Returns the arguments of a small, fast render: 16 lenses of 8 pixels.
Words small_teapot(const std::string& frames, const std::string& folder);

Words tool_command(const Words& arguments);

RunResult run_tool(const TempDir& dir, const Words& arguments, std::size_t file_size_limit = 0);

std::string bytes_of(const std::filesystem::path& path);

/// Runs the tool, which must succeed, and returns the pictures in the folder.
Files rendered(const TempDir& dir, const Words& arguments, const std::string& folder);

/// Throws if the text is not JSON.
nlohmann::json json_of(const std::string& text);

/// Runs the tool with --json, which must succeed, and returns its output.
nlohmann::json report_of(const TempDir& dir, const Words& arguments);

std::size_t lines_of(const std::string& text);

/// Returns how many frames a render with --verbose reports on stderr.
std::size_t reported_frames(const std::string& err);

/// Waits for a file that a running program makes. Returns false after a minute.
bool appears(const std::filesystem::path& path);

/// Runs the tool, which must succeed.
void expect_done(const TempDir& dir, const Words& arguments);

/// Expects one message of one line on stderr, nothing on stdout, and that exit code.
void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message);

}  // namespace lippmann::test

namespace nlohmann {

/// Prints unexpected values for GoogleTest.
void PrintTo(const json& value, std::ostream* stream);

}  // namespace nlohmann
