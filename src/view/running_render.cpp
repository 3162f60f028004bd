#include "view/running_render.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "folder/journal_writer.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

RenderState state_in(RenderStateReader& reader, const fs::path& folder) {
  if (std::optional<RenderState> state = reader.read()) return std::move(*state);
  throw Error(folder.string(), "holds no journal of a render", "a folder that `lippmann render` writes to");
}

Json frame_news(std::size_t index, const FrameFacts& facts) {
  Json json{{"index", index}};
  if (!facts.kind.empty()) json["kind"] = facts.kind;
  if (facts.psnr_db) json["psnr_db"] = *facts.psnr_db;
  return json;
}

}  // namespace

bool is_unfinished_render(const fs::path& folder) try {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return false;
  const std::optional<RenderState> state = RenderStateReader(folder).read();
  return state && state->activity != RenderActivity::kFinished;
} catch (const Error&) {
  return false;
}

RunningRender::RunningRender(fs::path folder, ToolCommand resuming, std::chrono::milliseconds poll_interval)
    : folder_(std::move(folder)),
      resuming_(std::move(resuming)),
      poll_interval_(poll_interval),
      reader_(folder_),
      state_(state_in(reader_, folder_)) {
  frames_ = state_.journal.asked;
  if (frames_.empty())
    throw Error(folder_.string(), "its journal lists no frames of a render", "the folder of a render that has begun");
  take(state_.journal);
}

std::optional<fs::path> RunningRender::file(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  const auto found = files_.find(index);
  return found == files_.end() ? std::nullopt : std::optional(found->second);
}

void RunningRender::take(const FolderJournal& journal) {
  for (std::size_t index = 0; index < frames_.size(); ++index) {
    const auto found = journal.frames.find(frames_[index]);
    if (found == journal.frames.end() || files_.contains(index)) continue;
    files_[index] = folder_ / picture_of(found->second);
    finished_.push_back({index, {found->second.report.kind, found->second.report.estimated_psnr_db}});
  }
}

/// The caller must hold mutex_.
void RunningRender::update() {
  const auto now = std::chrono::steady_clock::now();
  if (now - updated_ < poll_interval_) return;
  updated_ = now;
  try {
    state_ = state_in(reader_, folder_);
    take(state_.journal);
    std::erase_if(interrupted_, [&](const fs::path& part) {
      return std::find(state_.running.begin(), state_.running.end(), part) == state_.running.end();
    });
  } catch (const Error& error) {
    error_ = error.what();
  }
  if (!resumed_ || resumed_->is_running()) return;
  error_ = resumed_->failure();
  resumed_.reset();
}

std::string RunningRender::word() const {
  if (state_.activity == RenderActivity::kRunning && state_.running.size() == interrupted_.size()) return "stopping";
  if (state_.activity == RenderActivity::kRunning) return "running";
  if (resumed_) return "starting";
  if (state_.activity == RenderActivity::kElsewhere) return "elsewhere";
  return state_.activity == RenderActivity::kFinished ? "finished" : "stopped";
}

Json RunningRender::state_after(std::size_t known) {
  const std::lock_guard lock(mutex_);
  update();
  Json news = Json::array();
  for (std::size_t i = known; i < finished_.size(); ++i) news.push_back(frame_news(finished_[i].index, finished_[i].facts));
  return {{"state", word()},          {"frames", frames_.size()},
          {"done", finished_.size()}, {"seconds_left", state_.seconds_left ? Json(*state_.seconds_left) : Json()},
          {"host", state_.elsewhere}, {"folder", folder_.string()},
          {"error", error_},          {"finished", std::move(news)}};
}

void RunningRender::stop() {
  const std::lock_guard lock(mutex_);
  updated_ = {};
  update();
  bool interrupted = false;
  for (const fs::path& part : state_.running)
    if (interrupted_.contains(part) || interrupt_writer(part)) interrupted_.insert(part), interrupted = true;
  if (!interrupted && !resumed_)
    throw Error(folder_.string(), "no render on this machine writes into this folder", "the folder of a running render");
  if (!interrupted) resumed_->interrupt();  // the resumed process is not in the journal yet
}

void RunningRender::resume() {
  const std::lock_guard lock(mutex_);
  updated_ = {};
  update();
  if (resumed_ || !state_.running.empty())
    throw Error(folder_.string(), "a render is running in this folder", "stop the running render first");
  const fs::path job = folder_ / "job.toml";
  if (!is_as_written(state_.journal, folder_, "job.toml"))
    throw Error(job.string(), "was changed after the render wrote it, so the page does not run it",
                "`lippmann render` with `resume` and this job file, if you trust its contents");
  error_.clear();
  resumed_ = std::make_unique<ToolProcess>(resuming_);
}

}  // namespace lippmann
