// What a render says of itself in its report.json, as a page of figures needs it, and what it does not say.
//
// The file may be of another machine and another version, and of a render that was stopped: what is missing is said in
// sentences, and the rest is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// One run of several that may have worked at a render.
struct RunFigures {
  std::string host, cpu, unit, frames;  ///< empty: not recorded
  double setup_seconds = 0.0, write_seconds = 0.0;
  double peak_memory_bytes = 0.0;
  int threads = 0;
};

struct RenderFigures {
  std::filesystem::path report;  ///< the file
  std::string title;             ///< the name of the folder in which it lies
  std::string version, scene, light, view, reuse;
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  double frames_per_second = 25.0;
  bool interrupted = false;
  std::vector<FrameReport> frames;  ///< ascending
  std::vector<RunFigures> runs;
  std::optional<double> pixels;  ///< of a frame's film; none: the optics cannot be read
  double source_frames = 0.0;    ///< rendered only because others are made from them
  double cpu_seconds = 0.0;      ///< of all frames and source frames
  double setup_seconds = 0.0, write_seconds = 0.0, peak_memory_bytes = 0.0;
  std::vector<std::string> missing;  ///< sentences, for people
};

/// `report`: of `path`, as it was read. Throws Error naming the file where it lists no frames at all.
RenderFigures render_figures(const nlohmann::ordered_json& report, const std::filesystem::path& path);

}  // namespace lippmann
