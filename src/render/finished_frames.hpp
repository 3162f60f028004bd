// Which frames in an output folder are finished, and by which job: what --resume goes by. A journal in the folder, one line of
// JSON per finished frame, so that a render that was killed at any moment can be taken up again.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/file_checksum.hpp"
#include "display/display.hpp"
#include "render/frame_files.hpp"
#include "render/params.hpp"
#include "render/report.hpp"
#include "scene/scene.hpp"

namespace lippmann {

/// Tells jobs apart by all that decides the pictures: the parameters that change them, the scene, the display, this program's
/// version.
std::string job_fingerprint(const RenderParams& params, const Scene& scene, const Display* display = nullptr);

/// Files of a folder by their names relative to it, as they were when they were finished.
using FileRecords = std::map<std::string, FileChecksum>;

/// Of files that lie in `folder`. Throws Error naming the one that cannot be read.
FileRecords records_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// What a folder's journal says was finished, and what of it is still so.
struct FolderCheck {
  int frames = 0;                    ///< in the journal
  std::size_t files = 0;             ///< of them
  std::vector<std::string> missing;  ///< there is no such file
  std::vector<std::string> damaged;  ///< other bytes, or no regular file
  std::vector<std::string> foreign;  ///< frame_..., aov_... or view_... that no frame of the journal has
  bool passed() const { return missing.empty() && damaged.empty() && foreign.empty(); }
};

/// Reads every file of the journal in `folder`. Throws Error if there is no journal.
FolderCheck check_folder(const std::filesystem::path& folder);

/// What becomes of another job's render in the folder.
enum class OtherRender {
  kRefuse,   ///< Error
  kReplace,  ///< the files that its journal names are removed, and nothing else
};

class FinishedFrames {
 public:
  /// Opens the journal of `folder`, which exists. Torn lines and frames of which a file is not there with
  /// the recorded bytes are forgotten. Throws Error if the folder holds another job's render that `other` refuses, before
  /// anything is changed, or the journal cannot be written.
  FinishedFrames(std::filesystem::path folder, std::string fingerprint, FrameNames names,
                 OtherRender other = OtherRender::kRefuse);

  /// The figures of a frame that this job finished before; none if it has yet to be rendered.
  std::optional<FrameReport> find(int frame) const;

  /// Whether the folder held another job's render, whose files are removed.
  bool took_over() const { return took_over_; }

  /// Records a frame whose files are complete; find() does not see it. Throws Error. May run beside find(), not beside itself.
  void add(const FrameReport& frame, const FileRecords& files);

 private:
  std::filesystem::path folder_, journal_;
  FrameNames names_;
  std::map<int, FrameReport> finished_;
  std::ofstream out_;
  bool took_over_ = false;
};

}  // namespace lippmann
