// Checks that the files in a render's folder have the checksums in the folder's journal (folder/journal.hpp). Accepts files in
// folders without a journal, and files that the journal does not name.
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

/// Throws Error that names the file if the journal has checksums for it but none equals that of `bytes`, the whole file. The
/// journal is in the file's folder or in the parent folder. Also throws if the journal is damaged.
void require_as_recorded(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// Read a file as read_file_text() and read_file_bytes() (core/regular_file.hpp) do, and check it as require_as_recorded()
/// does.
std::string read_recorded_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_recorded_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                           const std::string& accepted = {});

/// Same as the overload above, for a file on the disk. Reads the whole file only if the journal names it.
void require_as_recorded(const std::filesystem::path& file);

void require_recorded_frames(const std::filesystem::path& folder);

std::set<std::string> recorded_names(const std::filesystem::path& folder);

bool has_journal(const std::filesystem::path& folder);

/// Returns whether the last line of a journal may be incomplete because a killed process wrote only its beginning, or because a
/// loss of power left zero bytes.
bool may_be_cut_line(std::string_view line);

}  // namespace lippmann
