// A render whose folder is shown while it runs, or once it was stopped: which frames are finished, how long the others take,
// and stopping or resuming it.
//
// All is learnt from the folder's journal (folder/render_state.hpp): the render is a process of its own, and may be started
// before or after the page, from a terminal or from here.
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

/// Whether a folder holds a render that runs, or that lacks frames. False for what is no folder of a render, or has a damaged
/// journal.
bool is_unfinished_render(const std::filesystem::path& folder);

/// Thread-safe.
class RunningRender {
 public:
  /// `resuming`: goes on with the folder's render. Throws Error if the folder holds no journal, or a damaged one.
  /// The folder is read again after `between_looks`, however many pages ask.
  RunningRender(std::filesystem::path folder, ToolCommand resuming,
                std::chrono::milliseconds between_looks = std::chrono::milliseconds(200));

  /// All that runs have been asked for when this was made, ascending; at least one.
  const std::vector<int>& frames() const { return frames_; }

  /// The file of the frame of that index, once it is finished.
  std::optional<std::filesystem::path> file(std::size_t index) const;

  /// What the page is told (docs/guide/view.md lists the keys), with the frames that were found finished after the first
  /// `known`.
  nlohmann::ordered_json state_after(std::size_t known);

  /// Does to the processes of this machine that render into the folder what Ctrl-C does. Throws Error if there are none.
  void stop();

  /// Goes on with the render in a process that ends with this. Throws Error where a render is under way, or where
  /// job.toml is not as renders have written it.
  void resume();

 private:
  struct Finished {
    std::size_t index;
    FrameFacts facts;
  };

  void look();
  void take(const FolderJournal& journal);
  std::string word() const;

  const std::filesystem::path folder_;
  const ToolCommand resuming_;
  const std::chrono::milliseconds between_looks_;
  mutable std::mutex mutex_;
  RenderStateReader reader_;
  RenderState state_;
  std::chrono::steady_clock::time_point looked_;
  std::vector<int> frames_;
  std::map<std::size_t, std::filesystem::path> files_;  ///< by index
  std::vector<Finished> finished_;                      ///< in the order in which they were found
  std::set<std::filesystem::path> interrupted_;         ///< parts of the journal whose processes have been told
  std::unique_ptr<ToolProcess> resumed_;
  std::string error_;
};

}  // namespace lippmann
