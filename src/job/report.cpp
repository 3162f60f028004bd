#include "job/report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "folder/frame_report_json.hpp"
#include "job/settings_json.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// Figures of the crosstalk correction with the amount of crosstalk; null without correction.
Json precompensation_json(const RenderReport& report) {
  Json json = to_json(precompensation_of(report));
  if (!report.crosstalk_px || json.is_null()) return nullptr;
  json["crosstalk_px"] = *report.crosstalk_px;
  json["neighbour_share"] = neighbour_share(*report.crosstalk_px);
  return json;
}

Json totals_json(const RenderReport& report) {
  double seconds = 0.0, cpu_seconds = 0.0;
  RayCounts rays;
  for (const auto* frames : {&report.frames, &report.strips, &report.run.sources})
    for (const FrameReport& frame : *frames) {
      seconds += frame.seconds;
      cpu_seconds += frame.cpu_seconds;
      add(frame.rays, rays);
    }
  return {{"seconds", seconds},
          {"cpu_seconds", cpu_seconds},
          {"write_seconds", report.run.write_seconds},
          {"setup_seconds", report.run.setup_seconds},
          {"frames", report.frames.size()},
          {"strips", report.strips.size()},
          {"source_frames", report.run.sources.size()},
          {"rays", to_json(rays)},
          {"peak_memory_bytes", report.run.peak_memory_bytes},
          {"threads", report.run.threads}};
}

/// Lists only the number of source frames of a run, because totals_json() includes their figures.
Json runs_json(const RenderReport& report) {
  Json runs = Json::array();
  for (const RunReport& run : report.runs.empty() ? std::vector{report.run} : report.runs) {
    runs.push_back(to_json(run));
    runs.back()["source_frames"] = run.sources.size();
    runs.back().erase("sources");
  }
  return runs;
}

}  // namespace

std::optional<Precompensation> precompensation_of(const RenderReport& report) {
  Precompensation all;
  int frames = 0;
  for (const FrameReport& frame : report.frames) {
    if (!frame.precompensation) continue;
    all.clipped_share += frame.precompensation->clipped_share;
    all.largest_residual = std::max(all.largest_residual, frame.precompensation->largest_residual);
    ++frames;
  }
  if (frames == 0) return std::nullopt;
  all.clipped_share /= frames;
  return all;
}

Json to_json(const RenderReport& report) {
  Json frames = Json::array();
  for (const FrameReport& frame : report.frames) frames.push_back(to_json(frame));
  return {
      {"version", version()},
      {"scene", report.scene},
      {"light", report.light},
      {"view", report.view},
      {"cut", report.cut},
      {"optics", optics_json(report.optics)},
      {"depth", depth_json(report.depth, report.depth_scale, report.optics)},
      {"precompensation", precompensation_json(report)},
      {"reuse", name_of(report.reuse)},
      {"settings", settings_json(report.params)},
      {"frames_per_second", report.frames_per_second},
      {"interrupted", report.interrupted},
      {"resumed", std::any_of(report.frames.begin(), report.frames.end(), [](const FrameReport& frame) { return frame.kept; })},
      {"videos", report.videos},
      {"frames", std::move(frames)},
      {"runs", runs_json(report)},
      {"totals", totals_json(report)}};
}

}  // namespace lippmann
