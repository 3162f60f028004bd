// How far the render in a folder is, while it runs or after it was stopped: what its journal says, and which processes write
// it.
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
  kElsewhere,  ///< a run of another machine has not recorded its end: it runs there, or was killed
  kStopped,    ///< frames are missing, and nobody makes them
  kFinished,   ///< all frames are there
};

struct RenderState {
  RenderActivity activity = RenderActivity::kStopped;
  FolderJournal journal;
  std::vector<std::filesystem::path> running;  ///< parts of the journal that processes of this machine write
  std::string elsewhere;                       ///< the other machine's name; empty: there is none
  std::optional<double> seconds_left;          ///< at the speed of now; none where that is not known yet
};

/// How fast a run has been so far; times in seconds since 1970.
struct RunPace {
  double began = 0.0, last = 0.0;  ///< when its journal begins; when its last frame was recorded
  int frames = 0;
};

/// All runs work at the frames that are left, each at its own pace; none where no run has finished a frame. At least 0.
std::optional<double> estimated_seconds_left(std::span<const RunPace> runs, int frames_left, double now);

/// Looks at one folder again and again. What has not grown since is not read again. Not thread-safe.
class RenderStateReader {
 public:
  explicit RenderStateReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// None if the folder holds no journal of a render. Throws Error for one that is damaged or cannot be read.
  std::optional<RenderState> read();

 private:
  struct Part {
    std::uintmax_t bytes = 0;
    FolderJournal journal;
  };

  const FolderJournal& part(const std::filesystem::path& path);

  std::filesystem::path folder_;
  std::map<std::filesystem::path, Part> parts_;
  std::uintmax_t bytes_ = 0;  ///< how large all parts together were when they were read last
  std::optional<FolderJournal> journal_;
};

/// The picture or the folder of views of a finished frame, relative to the render's folder.
std::filesystem::path picture_of(const JournalEntry& frame);

}  // namespace lippmann
