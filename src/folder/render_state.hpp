// Reads the progress of a render in a folder, active or stopped, from its journal and the processes that write it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "folder/journal.hpp"

namespace lippmann {

enum class RenderActivity {
  kRunning,    ///< at least one process of this machine writes the journal
  kElsewhere,  ///< a run on another machine has not recorded its end, so it is active or was killed
  kStopped,    ///< frames are missing and no run is active
  kFinished,   ///< all frames exist
};

struct RenderState {
  RenderActivity activity = RenderActivity::kStopped;
  FolderJournal journal;
  std::vector<std::filesystem::path> running;  ///< journal files written by processes of this machine
  std::string elsewhere;               ///< name of another machine whose run has not recorded its end; empty: there is none
  std::optional<double> seconds_left;  ///< at the current speed; nullopt: unknown
};

/// Times of a run, in seconds since 1970, from which its speed follows.
struct RunPace {
  double began = 0.0, last = 0.0;  ///< start of its journal, and time of its last recorded frame
  int frames = 0;
};

/// Estimates the seconds left if all runs share the remaining frames, each at its own speed; nullopt if no run has finished a
/// frame. The result is at least 0.
std::optional<double> estimated_seconds_left(std::span<const RunPace> runs, int frames_left, double now);

/// Polls one folder. Reads the journal again only if it has grown. Not thread-safe.
class RenderStateReader {
 public:
  explicit RenderStateReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Reads the state; nullopt if the folder holds no journal. Throws Error for a journal that is damaged or cannot be read.
  std::optional<RenderState> read();

 private:
  struct Part {
    std::uintmax_t bytes = 0;
    FolderJournal journal;
  };

  const FolderJournal& part(const std::filesystem::path& path);

  std::filesystem::path folder_;
  std::map<std::filesystem::path, Part> parts_;
  std::uintmax_t bytes_ = 0;  ///< total size of all journal files at the last read
  std::optional<FolderJournal> journal_;
};

/// Returns the picture or folder of views of a finished frame, relative to the render's folder.
std::filesystem::path picture_of(const JournalEntry& frame);

}  // namespace lippmann
