#include "job/folder_documents.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "job/job_file.hpp"
#include "job/job_fingerprint.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr const char* kJobFile = "job.toml";
constexpr const char* kReportFile = "report.json";

/// Times are added, even if runs overlapped in time.
RunReport all_of(const std::vector<RunReport>& runs) {
  RunReport all;
  for (const RunReport& run : runs) {
    all.setup_seconds += run.setup_seconds;
    all.write_seconds += run.write_seconds;
    all.peak_memory_bytes = std::max(all.peak_memory_bytes, run.peak_memory_bytes);
    all.threads = std::max(all.threads, run.threads);
    all.sources.insert(all.sources.end(), run.sources.begin(), run.sources.end());
  }
  std::stable_sort(all.sources.begin(), all.sources.end(),
                   [](const FrameReport& a, const FrameReport& b) { return a.frame < b.frame; });
  return all;
}

/// Frames of other runs are marked as kept.
RenderReport report_of(const RenderReport& run, const FolderJournal& journal) {
  RenderReport all = run;
  for (const auto& [frame, record] : journal.frames) {
    const auto is_it = [number = frame](const FrameReport& made) { return made.frame == number; };
    if (std::any_of(run.frames.begin(), run.frames.end(), is_it)) continue;
    all.frames.push_back(record.report);
    all.frames.back().kept = true;
  }
  std::sort(all.frames.begin(), all.frames.end(), [](const FrameReport& a, const FrameReport& b) { return a.frame < b.frame; });
  all.strips.clear();
  for (const auto& [frame, strips] : journal.strips)
    if (!journal.frames.contains(frame))
      for (const auto& [strip, record] : strips.finished) all.strips.push_back(record.report);
  all.run = all_of(journal.runs), all.runs = journal.runs;
  all.interrupted = all.frames.size() < journal.asked.size();
  return all;
}

bool are_same_paths(const std::vector<std::string>& some, const std::vector<std::string>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(), [](const std::string& a, const std::string& b) {
    return std::filesystem::absolute(a).lexically_normal() == std::filesystem::absolute(b).lexically_normal();
  });
}

std::string job_of_folder(const RenderParams& params, const FolderJournal& journal, const std::vector<int>& frames,
                          int frame_count, const std::vector<std::string>& videos, const std::filesystem::path& folder) {
  RenderParams whole = params;
  if (journal.companions.contains(kSingleFolder)) whole.output.also = Companion::kSingle;
  if (journal.companions.contains(kPageFolder)) whole.output.page = true;
  if (whole.output.video.empty()) whole.output.video = videos;
  if (journal.asked != frames) whole.output.frames = ranges_of(journal.asked);
  if (journal.asked != frames && static_cast<int>(journal.asked.size()) == frame_count) whole.output.frames.reset();
  return job_text(whole, folder);
}

std::vector<std::string> videos_in(const std::filesystem::path& job) try {
  RenderParams params;
  read_job(job, params);
  return params.output.video;
} catch (const Error&) {
  return {};
}

bool is_readable_job(const std::filesystem::path& job) try {
  RenderParams params;
  read_job(job, params);
  return true;
} catch (const Error&) {
  return false;
}

/// Returns whether a job file that differs from the journal is damaged. A file that the user has edited is not damaged: it can
/// be read, and has the settings of the resumed run. Users do not edit the job file in kSingleFolder.
bool is_damaged_job(const std::filesystem::path& file, const ResolvedJob& job, const RenderFolder& folder) {
  if (!job.params().resume || !folder.now().files.contains(kJobFile)) return false;
  const bool is_of_single = folder.path().filename() == kSingleFolder && has_journal(folder.path().parent_path());
  return is_of_single || !is_readable_job(file) || !differences(file, job).empty();
}

/// Returns whether earlier runs already included all frames and companion folders (additional renders) of this run.
bool holds_all(const FolderJournal& before, const FolderJournal& now) {
  return before.asked == now.asked && before.companions == now.companions;
}

}  // namespace

void write_job_of_folder(const ResolvedJob& job, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context) {
  const std::filesystem::path file = folder.path() / kJobFile;
  const bool is_there = is_regular_file_there(file);
  const bool is_as_recorded = is_there && is_as_written(folder.now(), folder.path(), kJobFile);
  const bool is_damaged = is_there && !is_as_recorded && is_damaged_job(file, job, folder);
  if (is_there && !is_as_recorded && !is_damaged) {
    if (const auto keys = differences(file, job); !keys.empty())
      context.warning(
          fmt::format("{} was not written by this render and is kept, although it differs in {}; report.json has the settings",
                      file.string(), fmt::join(keys, ", ")));
    return;
  }
  const std::vector<std::string> videos = is_as_recorded ? videos_in(file) : std::vector<std::string>();
  const bool has_same_videos = job.output().video.empty() || are_same_paths(job.output().video, videos);
  if (is_there && !is_damaged && has_same_videos && holds_all(folder.before(), folder.now())) return;
  folder.write(kJobFile, [&](const FolderJournal& journal) {
    return job_of_folder(job.params(), journal, frames, frame_count, videos, folder.path());
  });
}

void begin_report(const RenderReport& run, RenderFolder& folder) {
  if (!is_as_written(folder.now(), folder.path(), kReportFile)) write_report(run, folder);
}

RenderReport write_report(const RenderReport& run, RenderFolder& folder) {
  RenderReport all;
  folder.write(kReportFile, [&](const FolderJournal& journal) {
    all = report_of(run, journal);
    return json_to_text(to_json(all)) + '\n';
  });
  return all;
}

}  // namespace lippmann
