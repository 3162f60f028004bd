#include "job/finish_animation.hpp"

#include <set>

#include "core/regular_file.hpp"
#include "folder/render_folder.hpp"
#include "formats/frame_names.hpp"
#include "job/job_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJob = "job.toml";

std::vector<int> frames_to_render(const FolderCheck& check) {
  std::set<int> frames(check.unfinished.begin(), check.unfinished.end());
  for (const auto* names : {&check.damaged, &check.missing})
    for (const std::string& name : *names)
      if (const auto frame = frame_of_file(name)) frames.insert(*frame);
  for (const int frame : check.joinable) frames.erase(frame);
  return {frames.begin(), frames.end()};
}

/// Returns the job of the folder, with all frames that its runs were requested to render.
RenderParams job_of(const fs::path& folder, const std::vector<fs::path>& join) {
  const fs::path own = folder / kJob;
  const bool is_own = join.empty() || is_regular_file_there(own);
  RenderParams params;
  read_job(is_own ? own : join.front() / kJob, params);
  params.output.folder = folder.string();
  if (!is_own) params.output.frames = ranges_of(read_journal(folder).value_or(FolderJournal{}).asked);
  params.resume = true;
  return params;
}

/// Writes the job file of a folder into which other folders were joined, even if frames are missing.
void write_joint_job(const fs::path& folder, const RenderParams& params) {
  const std::string job = read_journal(folder).value_or(FolderJournal{}).job;
  RenderFolder(folder, job).write(kJob, [&](const FolderJournal&) { return job_text(params, folder); });
}

}  // namespace

FinishedAnimation finish_folder(const fs::path& folder, const std::vector<fs::path>& join, const CompleteFolder& complete) {
  FinishedAnimation finished;
  finished.joined = join_folders(folder, join);
  const RenderParams params = job_of(folder, join);
  if (!join.empty() && !is_regular_file_there(folder / kJob)) write_joint_job(folder, params);
  finished.check = check_folder(folder);
  finished.to_render = frames_to_render(finished.check);
  if (!finished.to_render.empty()) return finished;
  sync_render(folder, read_journal(folder).value_or(FolderJournal{}));
  finished.report = complete(params);
  return finished;
}

FinishedAnimation finish_animation(const fs::path& folder, const std::vector<fs::path>& join, const Context& context,
                                   const RenderObserver& observer) {
  RunParams run;
  run.only_finished = true;
  FinishedAnimation finished = finish_folder(
      folder, join, [&](const RenderParams& params) { return render_animation(ResolvedJob(params), context, observer, run); });
  if (!finished.report || finished.report->params.output.also != Companion::kSingle) return finished;
  const fs::path single = folder / kSingleFolder;
  std::vector<fs::path> singles;
  for (const fs::path& part : join)
    if (read_journal(part / kSingleFolder)) singles.push_back(part / kSingleFolder);
  const bool has_begun = !singles.empty() || read_journal(single).has_value();
  finished.has_single = has_begun && finish_animation(single, singles, context).report.has_value();
  return finished;
}

}  // namespace lippmann
