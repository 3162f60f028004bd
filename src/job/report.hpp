// Figures of a render, per frame and in total. report.json holds them; docs/reference/formats.md explains every key.
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
  Reuse reuse;        ///< the kind in effect
  std::string light;  ///< one sentence on the light used, and why
  std::string view;   ///< FittedArray::how
  std::string cut;    ///< PlacedOptics::cut
  ShownDepth depth;
  float depth_scale = 1.0f;            ///< factor of depth: depth on the display / depth in the scene
  std::optional<double> crosstalk_px;  ///< corrected crosstalk: a sigma in the optics' pixels or views
  double frames_per_second = 25.0;
  /// Figures of the frames, in ascending order; kept frames have the figures of the run that rendered them.
  std::vector<FrameReport> frames;
  std::vector<FrameReport> strips;  ///< figures of strips whose frames are not in `frames`
  RunReport run;                    ///< figures of this run besides those of its frames, or the totals of all runs
  std::vector<RunReport> runs;      ///< all runs that rendered into the folder; empty: `run` is the only one
  std::vector<std::string> videos;  ///< names of the video files
  bool interrupted = false;         ///< whether the run stopped before the last frame; the listed frames are complete
};

/// Returns the mean share of clipped samples and the largest residual over all frames; nullopt without crosstalk correction.
std::optional<Precompensation> precompensation_of(const RenderReport& report);

nlohmann::ordered_json to_json(const RenderReport& report);

}  // namespace lippmann
