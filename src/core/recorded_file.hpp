// Checks whether the files in a render's folder are unchanged since they were written, by the checksums in the folder's journal
// (folder/journal.hpp). Files in folders without a journal, and files that the journal does not name, are accepted.
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

/// Throws Error that names the file if its bytes differ from those that were recorded: if the journal of its folder, or of the
/// parent folder, has checksums for the file but none equals that of `bytes`. Also throws if the journal is damaged. `bytes`:
/// the whole file.
void require_as_recorded(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Read a file as read_file_text() and read_file_bytes() (core/regular_file.hpp) do, and check it as require_as_recorded()
/// does.
std::string read_recorded_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_recorded_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                           const std::string& accepted = {});

/// Checks a file that the caller reads piece by piece. If the journal names the file, reads it completely.
void require_as_recorded(const std::filesystem::path& file);

/// Throws Error if a frame file in the folder's journal is missing; the message names the first one.
void require_recorded_frames(const std::filesystem::path& folder);

/// Returns the names of the frame files, job.toml and report.json in a folder's journal, relative to the folder.
std::set<std::string> recorded_names(const std::filesystem::path& folder);

/// Returns whether a folder has a journal with at least one complete line. A journal whose files are empty counts as none.
bool has_journal(const std::filesystem::path& folder);

/// Returns whether the last line of a journal may be incomplete, because the process was killed or because a loss of power left
/// zeros. If it returns false, the line is invalid.
bool may_be_cut_line(std::string_view line);

}  // namespace lippmann
