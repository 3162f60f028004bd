// The journal of an output folder: whose render the folder holds, which of its files are finished, and what bytes they have.
//
// Its first line claims the folder for the run's job, before anything else is written there.
//
// Every run writes a file of its own, .lippmann/TIME-HOST-PROCESS.jsonl, and never touches another's: renders of parts of one
// job may run beside each other, on other machines too, and one that was killed at any moment can be taken up again. Together
// they are the journal. One JSON object a line; lines are only ever added:
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
// A journal may have been written by anybody: its names are those of files that a render writes, below its folder and nowhere
// else (videos: names of videos, anywhere), and its numbers are within reason.
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

/// Files of a folder by their names relative to it, as they were when they were finished.
using FileRecords = std::map<std::string, FileChecksum>;

/// Makes sure that a loss of power leaves files in `folder`, or in folders in it, under their names.
void sync_names(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// The records of files that lie in `folder`, once their names are safe from a loss of power. Throws Error naming the one that
/// cannot be read.
FileRecords records_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

struct JournalEntry {
  FrameReport report;
  FileRecords files;
};

/// A strip of a frame, from 0 at the top.
struct StripNumber {
  int frame = 0, strip = 0;
  int count = 1;  ///< that the frame has
};

struct JournalStrips {
  int count = 1;                         ///< that the frame has
  std::map<int, JournalEntry> finished;  ///< by strip; of several lines for a strip the last one counts
};

struct JournalVideo {
  std::vector<FileChecksum> sums;  ///< that runs have given it; none: one was stopped while it put the video in place
  std::vector<int> frames;         ///< that it shows, ascending
  std::vector<FileChecksum> side;  ///< that runs have given its side file; none: it has none
};

/// Folders that a render writes in its own: a render of its own, with a journal; a page for browsers.
inline constexpr const char* kSingleFolder = "single";
inline constexpr const char* kPageFolder = "page";

/// What a run did and took beside the figures of its frames.
struct RunReport {
  std::string host = {};                        ///< the machine's name
  std::string cpu = {};                         ///< its processor's; empty: not recorded
  std::string unit = {};                        ///< such as 7/200; empty: all frames
  std::vector<int> frames = {};                 ///< that it rendered, ascending
  std::map<int, std::vector<int>> strips = {};  ///< that it rendered, by frame, ascending
  double setup_seconds = 0.0;                   ///< wall time before the first frame: loading, building
  double write_seconds = 0.0;  ///< time that files took to encode and write, summed over threads; beside rendering
  std::uint64_t peak_memory_bytes = 0;
  int threads = 1;
  std::vector<FrameReport> sources = {};  ///< rendered only because frames are made from them; ascending
};

struct FolderJournal {
  std::string job;                      ///< whose render it is
  std::vector<int> asked;               ///< the frames that runs of the job were to render, each once, ascending
  std::set<std::string> companions;     ///< that runs of the job were to write: kSingleFolder, kPageFolder
  FileRecords page;                     ///< files of the page, by path relative to the folder
  std::map<int, JournalEntry> frames;   ///< finished; of several lines for a frame the last one counts
  std::map<int, JournalStrips> strips;  ///< by frame; their files are gone once the frame is finished
  std::map<std::string, std::vector<FileChecksum>> files;  ///< job.toml, report.json: as runs have written them
  std::map<std::string, JournalVideo> videos;              ///< by path relative to the folder
  std::vector<RunReport> runs;                             ///< that have ended
  std::vector<std::filesystem::path> parts;                ///< the files that it was read from, one for each run
  std::vector<std::filesystem::path> claims;               ///< files of runs of other jobs, which have finished nothing
  std::string problem;  ///< what is wrong with the first line that is none of the above, and which it is; empty: all are sound
};

/// Whether files remain that somebody may want. A render that was stopped before its first frame holds nothing.
bool holds_anything(const FolderJournal& journal);

/// Whether a file has bytes of one of these checksums.
bool is_as_written(const std::filesystem::path& file, const std::vector<FileChecksum>& sums);

/// Whether a file that several runs write, job.toml or report.json, has bytes that one of them has given it.
bool is_as_written(const FolderJournal& journal, const std::filesystem::path& folder, const std::string& name);

/// Whether all these files of a folder have the bytes that were recorded.
bool are_as_recorded(const std::filesystem::path& folder, const FileRecords& files);

/// As a journal and report.json have it.
nlohmann::ordered_json to_json(const RunReport& run);

/// Where the files of a journal are.
std::filesystem::path journal_folder(const std::filesystem::path& folder);

/// Returns nothing if no run has written there. `problem` names a damaged line, or two runs of different jobs that both
/// finished something; a torn last line is not a problem. Throws Error for a journal that is no regular file or cannot be read.
std::optional<FolderJournal> read_journal(const std::filesystem::path& folder);

/// What one run has written: its frames, what it was asked for, and its end once it has ended. A file that is gone says
/// nothing.
FolderJournal read_journal_part(const std::filesystem::path& part);

/// Makes sure that a loss of power leaves the journal as it was read, and the frames under their names: of a run that was
/// killed, the last line and the last names may not be safe yet.
void sync_render(const std::filesystem::path& folder, const FolderJournal& journal);

/// Throws Error if the journal has a problem.
void require_sound(const std::filesystem::path& folder, const FolderJournal& journal);

/// Lines of a journal, each with its end.
std::string job_line(const std::string& job);
std::string asked_line(const std::vector<int>& frames, const std::set<std::string>& companions = {});
std::string frame_line(const FrameReport& frame, const FileRecords& files);
std::string strip_line(const StripNumber& strip, const FrameReport& report, const FileRecords& files);
std::string written_line(const std::string& name, const FileChecksum& sum);
std::string video_line(const std::string& name, const std::vector<int>& frames, const std::optional<FileChecksum>& sum,
                       const std::optional<FileChecksum>& side = {});
std::string page_line(const FileRecords& files);
std::string run_line(const RunReport& run);

/// Whether a file is of a frame that was asked for and is not finished, or a strip of one that was: a render that was stopped
/// may have left it.
bool is_unfinished(const FolderJournal& journal, const std::string& name);

/// The name of a video's side file.
std::string side_name(const std::string& video);

/// Whether a video of that path relative to the folder lies directly in the folder.
bool lies_in_folder(const std::string& video);

}  // namespace lippmann
