// Checks whether the files in a render's folder are unchanged since they were written, by the folder's journal
// (folder/journal.hpp). Folders without a journal, and files that the journal does not name, are accepted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// Throws Error that names the file if the journal of its folder, or of the parent folder, is damaged or has only other
/// checksums for the file than that of `bytes`. `bytes`: the whole file.
void require_as_recorded(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Like read_file_text() and read_file_bytes() (core/regular_file.hpp), with this check.
std::string read_recorded_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_recorded_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                           const std::string& accepted = {});

/// Checks a file that is read piece by piece: reads it completely if the journal names it.
void require_as_recorded(const std::filesystem::path& file);

/// Throws Error that names the first frame file in the folder's journal that is missing.
void require_recorded_frames(const std::filesystem::path& folder);

/// Returns the names of the frame files, job.toml and report.json in a folder's journal, relative to the folder.
std::set<std::string> recorded_names(const std::filesystem::path& folder);

/// Returns whether a folder has a journal with at least one complete line. An emptied journal counts as none.
bool has_journal(const std::filesystem::path& folder);

/// Returns whether the end of a journal may be an incomplete line: from a killed process, or from a loss of power, which leaves
/// zeros. Otherwise the line is invalid.
bool may_be_cut_line(std::string_view line);

}  // namespace lippmann
