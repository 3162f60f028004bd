#include "job/job_folder.hpp"

#include <fmt/core.h>

#include <limits>
#include <set>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "folder/claim_folder.hpp"
#include "folder/strips.hpp"
#include "job/folder_documents.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

std::set<std::string> companions_of(const OutputParams& output) {
  std::set<std::string> names;
  if (output.also == Companion::kSingle) names.insert(kSingleFolder);
  if (output.page) names.insert(kPageFolder);
  return names;
}

}  // namespace

RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& fingerprint, const ResolvedJob& job,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context) {
  make_folder(path);
  remove_stale_temporaries(path);
  RenderFolder folder(path, fingerprint, [&](const std::filesystem::path& own) {
    clear_folder(path, {.job = fingerprint, .frames = frames, .force = force, .own = own}, context);
  });
  folder.begin(frames, companions_of(job.output()));
  write_job_of_folder(job, frames, frame_count, folder, context);
  return folder;
}

std::vector<std::string> words_to_resume(const std::filesystem::path& folder) {
  return {"render", (folder / "job.toml").string(), "--resume", "-o", folder.string(), "--quiet"};
}

void take_frames(const std::vector<int>& frames, RenderFolder& folder, const FrameSteps& steps) {
  for (const int frame : frames) {
    if (const auto kept = steps.keeps_finished ? folder.find(frame) : std::nullopt) {
      steps.keep(*kept);
      continue;
    }
    if (steps.only_finished)
      throw Error(folder.path().string(), fmt::format("frame {} is not finished, or was changed after it was written", frame),
                  "a folder with all frames of the job");
    if (!steps.make(frame)) return;
  }
}

std::vector<int> parts_of(const std::vector<int>& frames, int count) {
  std::vector<int> parts;
  const int most = std::numeric_limits<int>::max() / count - 1;
  if (!frames.empty() && frames.back() > most)
    throw usage_error("strips", fmt::format("{} strips are too many for frame {}", count, frames.back()), "fewer strips");
  for (const int frame : frames)
    for (int strip = 0; strip < count; ++strip) parts.push_back(frame * count + strip);
  return parts;
}

std::vector<int> frames_of_parts(const std::vector<int>& parts, int count) {
  std::vector<int> frames;
  for (const int part : parts)
    if (frames.empty() || frames.back() != part / count) frames.push_back(part / count);
  return frames;
}

std::map<int, std::vector<int>> strips_of_parts(const std::vector<int>& parts, int count) {
  std::map<int, std::vector<int>> strips;
  for (const int part : parts) strips[part / count].push_back(part % count);
  return strips;
}

bool is_finished_part(int part, int count, RenderFolder& folder, const FolderJournal& journal) {
  return folder.find(part / count) || find_strip(folder.path(), journal, part / count, part % count);
}

void take_strips(const std::vector<int>& parts, RenderFolder& folder, const StripSteps& steps) {
  const FolderJournal journal = steps.keeps_finished ? folder.now() : FolderJournal{};
  for (const int part : parts) {
    if (steps.keeps_finished && is_finished_part(part, steps.count, folder, journal)) continue;
    if (!steps.make(part / steps.count, part % steps.count)) return;
  }
}

std::vector<FrameReport> finished_strips(const RenderFolder& folder, int frame, int count) {
  const FolderJournal journal = folder.now();
  std::vector<FrameReport> reports;
  for (int strip = 0; strip < count; ++strip) {
    const std::optional<FrameReport> report = find_strip(folder.path(), journal, frame, strip);
    if (!report)
      throw Error(folder.path().string(),
                  fmt::format("strip {} of frame {} is not finished, or was changed after it was written", strip, frame),
                  fmt::format("a folder with all {} strips", count));
    reports.push_back(*report);
  }
  return reports;
}

}  // namespace lippmann
