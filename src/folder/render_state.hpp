// Reads the progress of a render from its journal and from the processes that write the journal.
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
  kRunning,  ///< a process of this machine writes the journal
  /// A run on another machine has not recorded its end. It is active or was killed.
  kElsewhere,
  kStopped,   ///< frames are missing and no run is active
  kFinished,  ///< all frames exist
};

struct RenderState {
  RenderActivity activity = RenderActivity::kStopped;
  FolderJournal journal;
  std::vector<std::filesystem::path> running;  ///< journal files that processes of this machine write
  /// Another machine whose run has not recorded its end; may be empty.
  std::string elsewhere;
  std::optional<double> seconds_left;  ///< at the current speed; nullopt if unknown
};

/// Times of a run, in seconds since 1970.
struct RunPace {
  double began = 0.0, last = 0.0;  ///< start of the run, and time of its last recorded frame
  int frames = 0;
};

/// Assumes that all runs share the remaining frames, each at its own speed. Returns nullopt if no run has finished a
/// frame, otherwise at least 0.
std::optional<double> estimated_seconds_left(std::span<const RunPace> runs, int frames_left, double now);

/// Polls one folder. Reads the journal again only if it has grown. Not thread-safe.
class RenderStateReader {
 public:
  explicit RenderStateReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Returns nullopt if the folder holds no journal. Throws Error if the journal is damaged or cannot be read.
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

/// Path of a finished frame's picture or folder of views, relative to the folder of the render.
std::filesystem::path picture_of(const JournalEntry& frame);

}  // namespace lippmann
