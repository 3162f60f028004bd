// Reads the figures of a render from its report.json.
//
// The file may come from another machine or version, or from a stopped render. Missing figures are listed as sentences, and all
// others are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// One of the runs that rendered frames.
struct RunFigures {
  std::string host, cpu, unit, frames;  ///< empty: not recorded
  double setup_seconds = 0.0, write_seconds = 0.0;
  double peak_memory_bytes = 0.0;
  int threads = 0;
};

struct RenderFigures {
  std::filesystem::path report;  ///< the file
  std::string title;             ///< name of the folder that contains it
  std::string version, scene, light, view, reuse;
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  double frames_per_second = 25.0;
  bool interrupted = false;
  std::vector<FrameReport> frames;  ///< in ascending order
  std::vector<RunFigures> runs;
  std::optional<double> pixels;  ///< of a frame's film; none: the optics cannot be read
  double source_frames = 0.0;    ///< frames rendered only to make others from them
  double cpu_seconds = 0.0;      ///< of all frames and source frames
  double setup_seconds = 0.0, write_seconds = 0.0, peak_memory_bytes = 0.0;
  std::vector<std::string> missing;  ///< sentences for people
};

/// Reads the figures. report: the parsed content of `path`. Throws Error naming the file if it has no list of frames.
RenderFigures render_figures(const nlohmann::ordered_json& report, const std::filesystem::path& path);

}  // namespace lippmann
