// Monitors a render that is running or was stopped: which frames are finished, the time left, and stopping or resuming it.
//
// All information comes from the folder's journal (folder/render_state.hpp). The render is a separate process, started before
// or after the page, from a terminal or from the page.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "folder/render_state.hpp"
#include "layout/rendered.hpp"
#include "view/tool_process.hpp"

namespace lippmann {

/// Returns whether the folder has a render that is running or lacks frames. False if it has no render or a damaged journal.
bool is_unfinished_render(const std::filesystem::path& folder);

/// Thread-safe.
class RunningRender {
 public:
  /// resuming: the command that continues the folder's render. The folder is read at most once per poll_interval, regardless of
  /// the number of pages. Throws Error if the journal is missing or damaged.
  RunningRender(std::filesystem::path folder, ToolCommand resuming,
                std::chrono::milliseconds poll_interval = std::chrono::milliseconds(200));

  /// Returns all requested frames at the time of construction, in ascending order; at least one.
  const std::vector<int>& frames() const { return frames_; }

  /// Returns the file of the frame with that index, or none until it is finished.
  std::optional<std::filesystem::path> file(std::size_t index) const;

  /// Returns the state for the page, with all finished frames except the first `known` that were found. web/README.md
  /// lists the keys.
  nlohmann::ordered_json state_after(std::size_t known);

  /// Interrupts the processes on this machine that render into the folder, like Ctrl-C. Throws Error if there are none.
  void stop();

  /// Continues the render in a child process that ends with this object. Throws Error if a render is running, or if job.toml is
  /// not the one written by the render.
  void resume();

 private:
  struct Finished {
    std::size_t index;
    FrameFacts facts;
  };

  void update();
  void take(const FolderJournal& journal);
  std::string word() const;

  const std::filesystem::path folder_;
  const ToolCommand resuming_;
  const std::chrono::milliseconds poll_interval_;
  mutable std::mutex mutex_;
  RenderStateReader reader_;
  RenderState state_;
  std::chrono::steady_clock::time_point updated_;
  std::vector<int> frames_;
  std::map<std::size_t, std::filesystem::path> files_;  ///< by index
  std::vector<Finished> finished_;                      ///< in the order in which they were found
  std::set<std::filesystem::path> interrupted_;         ///< journal parts of processes that were already interrupted
  std::unique_ptr<ToolProcess> resumed_;
  std::string error_;
};

}  // namespace lippmann
