// Whether the files in a render's folder are still those that it wrote, as the folder's journal says (folder/journal.hpp), for
// whoever opens one of them. A folder without a journal, and a file that the journal does not name, cannot be checked and pass.
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

/// Throws Error naming the file if the journal of the folder that it lies in, or of the one above, has other checksums for it
/// than `bytes` have, or is damaged. `bytes` are the whole file's.
void require_as_recorded(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// read_file_text() and read_file_bytes() (core/regular_file.hpp) of a file that may be a render's, checked as above.
std::string read_recorded_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_recorded_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                           const std::string& accepted = {});

/// The same of a file that is read piece by piece: reads it whole if the journal names it.
void require_as_recorded(const std::filesystem::path& file);

/// Throws Error naming the first file of a frame that the folder's journal names and that is gone.
void require_recorded_frames(const std::filesystem::path& folder);

/// The names of the files of frames, of job.toml and of report.json in a folder's journal, relative to the folder.
std::set<std::string> recorded_names(const std::filesystem::path& folder);

/// Whether a folder has a journal with at least one whole line: one that was emptied counts as none.
bool has_journal(const std::filesystem::path& folder);

/// Whether the end of a journal may be a line that was cut: by a process that was killed, or by a loss of power, which leaves
/// zeros in place of some of it. Else it is something that no render wrote.
bool may_be_cut_line(std::string_view line);

}  // namespace lippmann
