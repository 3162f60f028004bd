// Watches a render that is running or was stopped, and stops or resumes it. All information comes from the folder's journal
// (folder/render_state.hpp). The render is a separate process.
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
#include "formats/rendered.hpp"
#include "view/tool_process.hpp"

namespace lippmann {

/// True if the folder has a render that is running or lacks frames. False if its journal is damaged.
bool is_unfinished_render(const std::filesystem::path& folder);

/// Thread-safe.
class RunningRender {
 public:
  /// `resuming` is the command that continues the render. The folder is read at most once per poll_interval. Throws Error if
  /// the journal is missing or damaged.
  RunningRender(std::filesystem::path folder, ToolCommand resuming,
                std::chrono::milliseconds poll_interval = std::chrono::milliseconds(200));

  const std::filesystem::path& folder() const { return folder_; }

  /// Returns the frames that were requested when this object was made, in ascending order; at least one.
  const std::vector<int>& frames() const { return frames_; }

  /// Returns the file of the frame frames()[index], or nullopt until this frame is finished.
  std::optional<std::filesystem::path> file(std::size_t index) const;

  /// Returns the state for the page: finished frames in the order in which they were found, without the first `known`.
  /// web/README.md lists the keys.
  nlohmann::ordered_json state_after(std::size_t known);

  /// Interrupts all processes on this machine that render into the folder, like Ctrl-C. Throws Error if there are none.
  void stop();

  /// Continues the render in a child process, which ends with this object. Throws Error if a render is running, or if job.toml
  /// was changed since the render began.
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
  std::map<std::size_t, std::filesystem::path> files_;
  std::vector<Finished> finished_;
  std::set<std::filesystem::path> interrupted_;
  std::unique_ptr<ToolProcess> resumed_;
  std::string error_;
};

}  // namespace lippmann
