// Checks that the files in a render's folder are unchanged since they were written. Compares their checksums with the checksums
// in the folder's journal (folder/journal.hpp). Accepts files in folders without a journal, and files that the journal does not
// name.
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

/// Throws Error that names the file if the journal has checksums for the file but none equals the checksum of `bytes`, which
/// are the bytes of the whole file. The journal is in the file's folder or in the parent folder. Also throws if the journal is
/// damaged.
void require_as_recorded(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Read a file as read_file_text() and read_file_bytes() (core/regular_file.hpp) do, and check it as require_as_recorded()
/// does.
std::string read_recorded_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_recorded_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                           const std::string& accepted = {});

/// Throws Error as the overload above does, for a file on the disk. Reads the whole file only if the journal names it.
void require_as_recorded(const std::filesystem::path& file);

/// Throws Error if a frame file in the folder's journal is missing; the message names the first one.
void require_recorded_frames(const std::filesystem::path& folder);

/// Returns the names of the frame files, job.toml and report.json in a folder's journal, relative to the folder.
std::set<std::string> recorded_names(const std::filesystem::path& folder);

/// Returns whether a folder has a journal whose files contain at least one complete or invalid line.
bool has_journal(const std::filesystem::path& folder);

/// Returns whether `line`, an incomplete last line of a journal, may have been cut while it was written. A killed process
/// leaves the beginning of a line. A loss of power may leave zero bytes. Any other line is invalid.
bool may_be_cut_line(std::string_view line);

}  // namespace lippmann
