// The journal of an output folder records the render's job, its finished files, and their checksums.
//
// Every run writes a journal file, .lippmann/TIME-HOST-PROCESS.jsonl, and never changes the journal files of other runs.
// Several runs of one job may therefore render at the same time, also on different machines. A killed run can be resumed. All
// journal files together form the journal. The first line of a journal file claims the folder for the run's job, before any
// other file is written. Each line is a JSON object. Lines are only appended:
//
//   {"job": "..."}
//       The first line: job_fingerprint().
//   {"asked": "0-3", "companions": ["page"]}
//       The run will render these frames, and will write these companion folders.
//   {"frame": 2, ..., "files": {"frame_0002.png": {...}}}
//       A frame is finished. The line has its figures and its files.
//   {"strip": 3, "strips": 8, "frame": 2, ..., "files": {...}}
//       Strip 3 of the 8 strips of a frame is finished. The line has its figures and its file.
//   {"written": "report.json", "bytes": ..., "xxh3": "..."}
//       The run is about to put another file in place, with this size and checksum.
//   {"video": "a.mp4", "frames": "0-3", "bytes": ..., "xxh3": "..."}
//       A video is in place. Its path is relative to the folder. Without a checksum, the video is about to be written.
//   {"video": ..., "side": {"bytes": ..., "xxh3": "..."}}
//       A video is in place with its side file, VIDEO.json.
//   {"companion": "page", "files": {"page/index.html": {...}}}
//       Files of the page are in place.
//   {"run": {...}}
//       The run has ended. The line has the figures of the run, without those of its frames.
//
// A journal is untrusted input. File names must be names of files that a render writes inside its folder. Videos may be
// anywhere but must have names of videos. Numbers must be within their limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/file_checksum.hpp"
#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// Checksums of finished files by name, relative to the folder.
using FileRecords = std::map<std::string, FileChecksum>;

/// Syncs the directory entries of files in `folder` or its subfolders, so that they survive a power loss.
void sync_names(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// Syncs the directory entries of files in `folder` and returns their checksums. Throws Error that names a file that
/// cannot be read.
FileRecords records_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

struct JournalEntry {
  FrameReport report;
  FileRecords files;
};

/// Identifies a strip, a group of neighbouring rows that is rendered separately. Strip 0 is the topmost.
struct StripNumber {
  int frame = 0, strip = 0;
  int count = 1;  ///< strips per frame
};

struct JournalStrips {
  int count = 1;  ///< strips per frame
  /// Finished strips by number. If the journal has several lines for a strip, the last one counts.
  std::map<int, JournalEntry> finished;
};

struct JournalVideo {
  /// Checksums of all versions that were written; empty if a run stopped while writing the video.
  std::vector<FileChecksum> sums;
  std::vector<int> frames;  ///< in ascending order
  /// Checksums of all versions of the video's side file; empty if it has none.
  std::vector<FileChecksum> side;
};

/// Subfolders of a render. kSingleFolder holds the render of a single view beside a light field, with its own journal.
/// kPageFolder holds a page for browsers.
inline constexpr const char* kSingleFolder = "single";
inline constexpr const char* kPageFolder = "page";

/// The figures of a run, without those of its frames.
struct RunReport {
  std::string host = {};         ///< name of the machine
  std::string cpu = {};          ///< name of the processor; empty if not recorded
  std::string unit = {};         ///< 7/200 means the 7th of 200 parts of the job; empty: all frames
  std::vector<int> frames = {};  ///< rendered frames, in ascending order
  /// Rendered strips by frame, in ascending order.
  std::map<int, std::vector<int>> strips = {};
  double setup_seconds = 0.0;  ///< wall time before the first frame
  /// Time of encoding and writing, summed over threads. Overlaps with rendering.
  double write_seconds = 0.0;
  std::uint64_t peak_memory_bytes = 0;
  int threads = 1;
  /// Frames that were rendered only because other frames are made from them, in ascending order.
  std::vector<FrameReport> sources = {};
};

struct FolderJournal {
  std::string job;
  /// Frames that the runs of the job were requested to render, ascending and without duplicates.
  std::vector<int> asked;
  /// Requested companion folders: kSingleFolder, kPageFolder.
  std::set<std::string> companions;
  FileRecords page;  ///< files of the page, by their path relative to the folder
  /// Finished frames by number. If the journal has several lines for a frame, the last one counts.
  std::map<int, JournalEntry> frames;
  /// Finished strips by frame. Their files are deleted when the frame is finished.
  std::map<int, JournalStrips> strips;
  /// Checksums of all versions of job.toml, report.json and similar files, by name.
  std::map<std::string, std::vector<FileChecksum>> files;
  /// Videos, by their path relative to the folder.
  std::map<std::string, JournalVideo> videos;
  std::vector<RunReport> runs;
  /// Journal files that were read, one per run.
  std::vector<std::filesystem::path> parts;
  /// Journal files of runs that belong to other jobs and have finished no file.
  std::vector<std::filesystem::path> claims;
  /// Number and problem of the first invalid line; empty if all lines are valid.
  std::string problem;
};

/// Returns whether any file is finished. A render that stopped before its first frame has none.
bool holds_anything(const FolderJournal& journal);

/// Returns whether the file has one of the checksums `sums`.
bool is_as_written(const std::filesystem::path& file, const std::vector<FileChecksum>& sums);

/// Returns whether the file, such as job.toml or report.json, equals one of the versions that runs have written.
bool is_as_written(const FolderJournal& journal, const std::filesystem::path& folder, const std::string& name);

/// Returns whether all `files` match their checksums.
bool are_as_recorded(const std::filesystem::path& folder, const FileRecords& files);

nlohmann::ordered_json to_json(const RunReport& run);

std::filesystem::path journal_folder(const std::filesystem::path& folder);

/// Returns nullopt if no run has written in the folder. `problem` names a damaged line, or two runs of different jobs
/// that both finished files. An incomplete last line is no problem. Throws Error if a journal file is not a regular
/// file or cannot be read.
std::optional<FolderJournal> read_journal(const std::filesystem::path& folder);

/// Reads the journal file of one run. Returns an empty journal if it does not exist.
FolderJournal read_journal_part(const std::filesystem::path& part);

/// Syncs the journal and the names of the files that it records, because a killed run may not have synced its last files.
void sync_render(const std::filesystem::path& folder, const FolderJournal& journal);

/// Throws Error if the journal has a problem.
void require_sound(const std::filesystem::path& folder, const FolderJournal& journal);

/// These functions return lines of a journal, each with a newline at the end.
std::string job_line(const std::string& job);
std::string asked_line(const std::vector<int>& frames, const std::set<std::string>& companions = {});
std::string frame_line(const FrameReport& frame, const FileRecords& files);
std::string strip_line(const StripNumber& strip, const FrameReport& report, const FileRecords& files);
std::string written_line(const std::string& name, const FileChecksum& sum);
std::string video_line(const std::string& name, const std::vector<int>& frames, const std::optional<FileChecksum>& sum,
                       const std::optional<FileChecksum>& side = {});
std::string page_line(const FileRecords& files);
std::string run_line(const RunReport& run);

/// Returns whether the file belongs to a requested but unfinished frame, or to one of its strips. An interrupted render
/// may have left it.
bool is_unfinished(const FolderJournal& journal, const std::string& name);

std::string side_name(const std::string& video);

/// Returns whether a video with this path, relative to the folder, lies in the folder itself.
bool lies_in_folder(const std::string& video);

}  // namespace lippmann
