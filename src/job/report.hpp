// Figures of a render, per frame and in total, as in report.json (docs/reference/formats.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "folder/journal.hpp"
#include "job/params.hpp"
#include "lippmann/frames/frame_report.hpp"
#include "lippmann/optics/optics.hpp"
#include "stage/depth_budget.hpp"

namespace lippmann {

struct RenderReport {
  std::string scene;
  Optics optics;
  RenderParams params;
  Reuse reuse;        ///< the kind of reuse that was used
  std::string light;  ///< one sentence on the light, and the reason for it
  std::string view;   ///< one sentence on how the array was placed (FittedArray::how)
  std::string cut;    ///< one sentence on walls that hide the scene (PlacedOptics::cut)
  ShownDepth depth;
  /// Depth on the display divided by depth in the scene.
  float depth_scale = 1.0f;
  /// Corrected crosstalk: the standard deviation of the Gaussian blur (optics/crosstalk.hpp), in pixels, or in views
  /// for a quilt.
  std::optional<double> crosstalk_px;
  double frames_per_second = 25.0;
  /// In ascending order. Kept frames have the figures of the run that rendered them.
  std::vector<FrameReport> frames;
  std::vector<FrameReport> strips;  ///< strips whose frames are not in `frames`
  /// Figures of this run except those of its frames; in the report of a folder, the totals of all runs.
  RunReport run;
  /// All runs that rendered into the folder; empty if `run` is the only one.
  std::vector<RunReport> runs;
  std::vector<std::string> videos;
  /// The run stopped before its last frame. The frames in the report are complete.
  bool interrupted = false;
};

/// Mean share of clipped samples and largest residual of the crosstalk correction over all frames.
std::optional<Precompensation> precompensation_of(const RenderReport& report);

nlohmann::ordered_json to_json(const RenderReport& report);

}  // namespace lippmann
