// The journal of an output folder records the render's job, its finished files, and their checksums.
//
// The first line of a run's journal file claims the folder for the run's job before any other file is written.
//
// Every run writes its own file, .lippmann/TIME-HOST-PROCESS.jsonl, and never changes another run's. Several runs of one job
// may therefore render at the same time, also on other machines, and a killed run can be resumed. All files together are the
// journal. Each line is a JSON object. Lines are only appended:
//
//   {"job": "..."}                                          the first line: job_fingerprint()
//   {"asked": "0-3", "companions": ["page"]}                the run is to render these frames, and to write these folders
//                                                           beside them
//   {"frame": 2, ..., "files": {"frame_0002.png": {...}}}   a frame is finished: its figures, its files
//   {"strip": 3, "strips": 8, "frame": 2, ..., "files": {...}}  a strip of a frame is finished, of so many: its figures, its
//   file
//   {"written": "report.json", "bytes": ..., "xxh3": "..."} another file is about to be put in place, with these bytes
//   {"video": "a.mp4", "frames": "0-3", "bytes": ..., "xxh3": "..."}  a video is in place, by its path from the folder; without
//                                                           a checksum: is about to be
//   {"video": ..., "side": {"bytes": ..., "xxh3": "..."}}   the same with its side file, VIDEO.json
//   {"companion": "page", "files": {"page/index.html": {...}}}  files of the page are in place
//   {"run": {...}}                                          the run has ended: what it took beside its frames
//
// A journal is untrusted input. File names must be those of files that a render writes below its folder (videos: names of
// videos, anywhere), and numbers must be within their limits.
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

/// Checksums of finished files, by their names relative to the folder.
using FileRecords = std::map<std::string, FileChecksum>;

/// Syncs the names of files in `folder` or its subfolders, so that they survive a power loss.
void sync_names(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// Syncs the names of files in `folder` and returns their records. Throws Error naming a file that cannot be read.
FileRecords records_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

struct JournalEntry {
  FrameReport report;
  FileRecords files;
};

/// Identifies a strip of a frame. Strips are numbered from 0 at the top.
struct StripNumber {
  int frame = 0, strip = 0;
  int count = 1;  ///< strips per frame
};

struct JournalStrips {
  int count = 1;                         ///< strips per frame
  std::map<int, JournalEntry> finished;  ///< by strip; if a strip has several lines, the last one counts
};

struct JournalVideo {
  std::vector<FileChecksum> sums;  ///< checksums of all written versions; empty: a run stopped while writing the video
  std::vector<int> frames;         ///< frames of the video, ascending
  std::vector<FileChecksum> side;  ///< checksums of all versions of its side file; empty: it has none
};

/// Companion folders inside a render's folder: the single view's render, with its own journal, and a page for browsers.
inline constexpr const char* kSingleFolder = "single";
inline constexpr const char* kPageFolder = "page";

/// The figures of a run, apart from those of its frames.
struct RunReport {
  std::string host = {};                        ///< the machine's name
  std::string cpu = {};                         ///< name of the processor; empty: not recorded
  std::string unit = {};                        ///< e.g. 7/200; empty: all frames
  std::vector<int> frames = {};                 ///< frames rendered by the run, ascending
  std::map<int, std::vector<int>> strips = {};  ///< strips rendered by the run, by frame, ascending
  double setup_seconds = 0.0;                   ///< wall time before the first frame: loading, building
  double write_seconds = 0.0;                   ///< encoding and writing, summed over threads; overlaps rendering
  std::uint64_t peak_memory_bytes = 0;
  int threads = 1;
  std::vector<FrameReport> sources = {};  ///< source frames rendered besides the run's own; ascending
};

struct FolderJournal {
  std::string job;                      ///< fingerprint of the job
  std::vector<int> asked;               ///< frames requested by all runs of the job, unique, ascending
  std::set<std::string> companions;     ///< companions requested by runs of the job: kSingleFolder, kPageFolder
  FileRecords page;                     ///< files of the page, by path relative to the folder
  std::map<int, JournalEntry> frames;   ///< finished frames; if a frame has several lines, the last one counts
  std::map<int, JournalStrips> strips;  ///< by frame; their files are deleted when the frame is finished
  std::map<std::string, std::vector<FileChecksum>> files;  ///< checksums of all written versions of job.toml, report.json
  std::map<std::string, JournalVideo> videos;              ///< by path relative to the folder
  std::vector<RunReport> runs;                             ///< finished runs
  std::vector<std::filesystem::path> parts;                ///< journal files read, one per run
  std::vector<std::filesystem::path> claims;               ///< journal files of other jobs' runs that finished nothing
  std::string problem;  ///< number and problem of the first invalid line; empty: all are valid
};

/// Returns whether the render finished any file. A render stopped before its first frame has none.
bool holds_anything(const FolderJournal& journal);

/// Returns whether a file has one of these checksums.
bool is_as_written(const std::filesystem::path& file, const std::vector<FileChecksum>& sums);

/// Returns whether the file `name` (job.toml or report.json) equals one of the versions that runs have written.
bool is_as_written(const FolderJournal& journal, const std::filesystem::path& folder, const std::string& name);

/// Returns whether all files in `files` match their records.
bool are_as_recorded(const std::filesystem::path& folder, const FileRecords& files);

/// Returns a run's figures in the JSON form of journals and report.json.
nlohmann::ordered_json to_json(const RunReport& run);

/// Returns the folder of the journal's files.
std::filesystem::path journal_folder(const std::filesystem::path& folder);

/// Reads the journal of a folder; nullopt if no run has written there. `problem` names a damaged line, or two runs of different
/// jobs that both finished something. An incomplete last line is not a problem. Throws Error for a journal that is not a
/// regular file or cannot be read.
std::optional<FolderJournal> read_journal(const std::filesystem::path& folder);

/// Reads the journal file of one run. Returns an empty journal if the file does not exist.
FolderJournal read_journal_part(const std::filesystem::path& part);

/// Syncs the journal and the names of the frames' files. A killed run may not have synced its last line and last names.
void sync_render(const std::filesystem::path& folder, const FolderJournal& journal);

/// Throws Error if the journal has a problem.
void require_sound(const std::filesystem::path& folder, const FolderJournal& journal);

/// The following functions return lines of a journal, each with a newline at its end.
std::string job_line(const std::string& job);
std::string asked_line(const std::vector<int>& frames, const std::set<std::string>& companions = {});
std::string frame_line(const FrameReport& frame, const FileRecords& files);
std::string strip_line(const StripNumber& strip, const FrameReport& report, const FileRecords& files);
std::string written_line(const std::string& name, const FileChecksum& sum);
std::string video_line(const std::string& name, const std::vector<int>& frames, const std::optional<FileChecksum>& sum,
                       const std::optional<FileChecksum>& side = {});
std::string page_line(const FileRecords& files);
std::string run_line(const RunReport& run);

/// Returns whether a file belongs to a requested but unfinished frame, or to a strip of one. An interrupted render may have
/// left it.
bool is_unfinished(const FolderJournal& journal, const std::string& name);

/// Returns the name of a video's side file.
std::string side_name(const std::string& video);

/// Returns whether a video, given relative to the folder, lies directly in it.
bool lies_in_folder(const std::string& video);

}  // namespace lippmann
