// What the tests of the command-line tool share: running it in a folder, and looking at what it left there.
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

/// A small, quick picture: 16 lenses of 8 pixels.
Words small_teapot(const std::string& frames, const std::string& folder);

Words tool_command(const Words& arguments);

RunResult run_tool(const TempDir& dir, const Words& arguments, std::size_t file_size_limit = 0);

std::string bytes_of(const std::filesystem::path& path);

/// Runs the tool, which must not fail; the pictures that are then in the folder.
Files rendered(const TempDir& dir, const Words& arguments, const std::string& folder);

/// Throws if the text is no JSON.
nlohmann::json json_of(const std::string& text);

/// Runs the tool with --json, which must not fail: what it printed.
nlohmann::json report_of(const TempDir& dir, const Words& arguments);

std::size_t lines_of(const std::string& text);

/// How many frames a render with --verbose says on stderr that it has made.
std::size_t frames_said(const std::string& err);

/// Waits for a file that a running program is to make; false after a minute.
bool appears(const std::filesystem::path& path);

/// Runs the tool, which must not fail.
void expect_done(const TempDir& dir, const Words& arguments);

/// One message of one line on stderr, nothing on stdout, and that exit code.
void expect_refusal(const RunResult& result, int exit_code, const std::string& part_of_message);

}  // namespace lippmann::test

namespace nlohmann {

/// What GoogleTest prints where a value is not as expected.
void PrintTo(const json& value, std::ostream* stream);

}  // namespace nlohmann
