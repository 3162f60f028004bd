#include "job/folder_documents.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "job/job_file.hpp"
#include "job/job_fingerprint.hpp"

namespace lippmann {
namespace {

constexpr const char* kJobFile = "job.toml";
constexpr const char* kReportFile = "report.json";

/// What all runs took together: beside each other or after each other, times add up.
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

/// Every frame of the journal; those that this run did not make are kept.
RenderReport report_of(const RenderReport& run, const FolderJournal& journal) {
  RenderReport all = run;
  for (const auto& [frame, record] : journal.frames) {
    const auto is_it = [frame = frame](const FrameReport& made) { return made.frame == frame; };
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

std::string job_of_folder(const RenderParams& params, const FolderJournal& journal, const std::vector<int>& frames,
                          int frame_count, const std::filesystem::path& folder) {
  RenderParams whole = params;
  if (journal.asked != frames) whole.output.frames = ranges_of(journal.asked);
  if (journal.asked != frames && static_cast<int>(journal.asked.size()) == frame_count) whole.output.frames.reset();
  return job_text(whole, folder);
}

}  // namespace

void write_job_of_folder(const RenderParams& params, const std::vector<int>& frames, int frame_count, RenderFolder& folder,
                         const Context& context) {
  const std::filesystem::path file = folder.path() / kJobFile;
  const bool is_there = is_regular_file_there(file);
  if (is_there && !is_as_written(folder.now(), folder.path(), kJobFile)) {
    if (const auto keys = differences(file, params); !keys.empty())
      context.warning(
          fmt::format("{} was not written by this render and stays, although it differs in {}; report.json has the settings",
                      file.string(), fmt::join(keys, ", ")));
    return;
  }
  const std::vector<int>& before = folder.before().asked;
  if (is_there && std::includes(before.begin(), before.end(), frames.begin(), frames.end())) return;
  folder.write(kJobFile, [&](const FolderJournal& journal) {
    return job_of_folder(params, journal, frames, frame_count, folder.path());
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
