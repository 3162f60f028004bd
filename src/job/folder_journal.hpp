// The journal of an output folder, .lippmann-frames.jsonl: whose render the folder holds, which of its files are finished, and
// what bytes they have. One JSON object a line; lines are only ever added, so that a render that was killed at any moment can
// be taken up again, and renders of parts of one job may run beside each other.
//
//   {"job": "..."}                                          the first line: job_fingerprint()
//   {"asked": "0-3"}                                        a run begins that is to render these frames
//   {"frame": 2, ..., "files": {"frame_0002.png": {...}}}   a frame is finished: its figures, its files
//   {"written": "report.json", "bytes": ..., "xxh3": "..."} the same of another file; without a checksum: taken away
//   {"video": "a.mp4", "frames": "0-3", "bytes": ..., "xxh3": "..."}  the same of a video, by its path from the folder; without
//                                                           a checksum: is about to appear
//
// A journal may have been written by anybody: its names are those of files that a render writes, below its folder and nowhere
// else (videos: names of videos, anywhere), and its numbers are within reason.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/file_checksum.hpp"
#include "job/report.hpp"

namespace lippmann {

/// Files of a folder by their names relative to it, as they were when they were finished.
using FileRecords = std::map<std::string, FileChecksum>;

/// Of files that lie in `folder`. Throws Error naming the one that cannot be read.
FileRecords records_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

struct JournalFrame {
  FrameReport report;
  FileRecords files;
};

struct JournalVideo {
  std::optional<FileChecksum> sum;  ///< none: the render was stopped while it put the video in place
  std::vector<int> frames;          ///< that it shows, ascending
};

struct FolderJournal {
  std::string job;                             ///< whose render it is
  std::vector<int> asked;                      ///< the frames that runs of the job were to render, each once, ascending
  std::map<int, JournalFrame> frames;          ///< finished; of several lines for a frame the last one counts
  FileRecords files;                           ///< job.toml, report.json
  std::map<std::string, JournalVideo> videos;  ///< by path relative to the folder
  std::string problem;                         ///< of the first line that is none of the above; empty: all are sound
  std::uintmax_t sound_bytes = 0;              ///< from the beginning, without a torn line at the end
};

std::filesystem::path journal_path(const std::filesystem::path& folder);

/// None if there is no journal. What is wrong with a line stands in `problem`; a torn last line is no problem. Throws Error for
/// a journal that is no regular file or cannot be read.
std::optional<FolderJournal> read_journal(const std::filesystem::path& folder);

/// Throws Error if the journal has a problem.
void require_sound(const std::filesystem::path& folder, const FolderJournal& journal);

/// Lines of a journal, each with its end.
std::string job_line(const std::string& job);
std::string asked_line(const std::vector<int>& frames);
std::string frame_line(const FrameReport& frame, const FileRecords& files);
std::string written_line(const std::string& name, const std::optional<FileChecksum>& sum);
std::string video_line(const std::string& name, const JournalVideo& video);

/// The frame that a file of this name, relative to a render's folder, belongs to: a picture, a layer, a side file; none if no
/// render writes files of such a name.
std::optional<int> frame_of_file(const std::string& name);

/// Whether a file is of a frame that was asked for and is not finished: a render that was stopped may have left it.
bool is_unfinished(const FolderJournal& journal, const std::string& name);

/// Whether a video of that path relative to the folder lies directly in the folder.
bool lies_in_folder(const std::string& video);

}  // namespace lippmann
