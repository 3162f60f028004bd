#include "job/job_folder.hpp"

#include <fmt/core.h>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "folder/claim_folder.hpp"
#include "job/folder_documents.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& job, const RenderParams& params,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context) {
  make_folder(path);
  remove_stale_temporaries(path);
  clear_folder(path, job, frames, force, context);
  RenderFolder folder(path, job);
  folder.begin(frames);
  write_job_of_folder(params, frames, frame_count, folder, context);
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
      throw Error(folder.path().string(), fmt::format("frame {} is not finished, or not as it was written", frame),
                  "a folder in which all frames are");
    if (!steps.make(frame)) return;
  }
}

}  // namespace lippmann
