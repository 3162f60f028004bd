// Reads the report.json of a render. The file may come from another machine, another version, or a stopped render. Sentences
// for the user state what is missing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

struct RunFigures {
  std::string host, cpu, unit, frames;
  double setup_seconds = 0.0, write_seconds = 0.0;
  double peak_memory_bytes = 0.0;
  int threads = 0;
};

struct RenderFigures {
  std::filesystem::path report;
  std::string title;
  std::string version, scene, light, view, reuse;
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  double frames_per_second = 25.0;
  bool interrupted = false;
  std::vector<FrameReport> frames;
  std::vector<RunFigures> runs;
  /// Number of pixels of a film; nullopt if the optics cannot be read.
  std::optional<double> pixels;
  double source_frames = 0.0;  ///< number of frames that were rendered only as sources of other frames
  double cpu_seconds = 0.0;
  double setup_seconds = 0.0, write_seconds = 0.0, peak_memory_bytes = 0.0;
  std::vector<std::string> missing;  ///< sentences for the user on missing values
};

/// `report` is the content of `path`. Throws Error naming the file if it has no list of frames.
RenderFigures render_figures(const nlohmann::ordered_json& report, const std::filesystem::path& path);

}  // namespace lippmann
