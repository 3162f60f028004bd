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
  Reuse reuse;        ///< that served
  std::string light;  ///< one sentence: which light was taken, and why
  std::string view;   ///< FittedArray::how
  ShownDepth depth;
  float depth_scale = 1.0f;            ///< shown depth / true depth
  std::optional<double> crosstalk_px;  ///< undone: a sigma in the optics' pixels or views
  double frames_per_second = 25.0;
  std::vector<FrameReport> frames;  ///< in ascending order; frames kept from before with the figures of then
  std::vector<FrameReport> strips;  ///< what those took that belong to none of these frames
  RunReport run;                    ///< what it took beside its frames, or what all runs took
  std::vector<RunReport> runs;      ///< every run that has rendered into the folder; empty: `run` alone
  std::vector<std::string> videos;  ///< files, as they are named on disk
  bool interrupted = false;         ///< stopped before the last frame; what is listed is whole
};

/// Over all frames: the mean share clipped, the largest residual of any. None where no crosstalk was undone.
std::optional<Precompensation> precompensation_of(const RenderReport& report);

nlohmann::ordered_json to_json(const RenderReport& report);

}  // namespace lippmann
