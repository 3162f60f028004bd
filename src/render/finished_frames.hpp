// Which frames in an output folder are finished, and by which job: what --resume goes by. A journal in the folder, one line of
// JSON per finished frame, so that a render that was killed at any moment can be taken up again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "display/display.hpp"
#include "render/frame_files.hpp"
#include "render/params.hpp"
#include "render/report.hpp"
#include "scene/scene.hpp"

namespace lippmann {

/// Tells jobs apart by all that decides the pictures: the parameters that change them, the scene, the display, this program's
/// version.
std::string job_fingerprint(const RenderParams& params, const Scene& scene, const Display* display = nullptr);

class FinishedFrames {
 public:
  /// Opens the journal of `folder`, which exists. Lines of another job, torn lines, and frames whose picture is not there in
  /// the recorded size are forgotten. Throws Error if the journal cannot be written.
  FinishedFrames(std::filesystem::path folder, std::string fingerprint, FrameNames names);

  /// The figures of a frame that this job finished before; none if it has yet to be rendered.
  std::optional<FrameReport> find(int frame) const;

  /// Whether the folder held frames of another job, which are now only files.
  bool took_over() const { return took_over_; }

  /// Records a frame whose files are complete; find() does not see it. Throws Error. May run beside find(), not beside itself.
  void add(const FrameReport& frame);

 private:
  std::filesystem::path folder_, journal_;
  FrameNames names_;
  std::map<int, FrameReport> finished_;
  std::ofstream out_;
  bool took_over_ = false;
};

}  // namespace lippmann
