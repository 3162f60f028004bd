#include "job/report.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "job/params_table.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

Json rays_json(const RayCounts& rays) {
  return {{"primary", rays.primary}, {"shadow", rays.shadow}, {"reflection", rays.reflection}, {"indirect", rays.indirect}};
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> number_or_none(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Json precompensation_json(const std::optional<Precompensation>& done) {
  if (!done) return nullptr;
  return {{"clipped_share", done->clipped_share}, {"largest_residual", done->largest_residual}};
}

std::optional<Precompensation> precompensation_from_json(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Precompensation{json.at("clipped_share").get<double>(), json.at("largest_residual").get<double>()};
}

/// With what was undone.
Json precompensation_json(const RenderReport& report) {
  Json json = precompensation_json(precompensation_of(report));
  if (!report.crosstalk_px || json.is_null()) return nullptr;
  json["crosstalk_px"] = *report.crosstalk_px;
  json["neighbour_share"] = neighbour_share(*report.crosstalk_px);
  return json;
}

Json setting_json(const ParamInfo& info, const RenderParams& params) {
  const std::vector<std::string> values = info.get(params);
  if (info.kind == ParamKind::kList) return values;
  if (values.empty()) return nullptr;
  if (info.kind == ParamKind::kText) return values.front();
  return json_from_text(values.front());  // numbers and flags are written as JSON writes them
}

Json settings_json(const RenderParams& params) {
  Json json = Json::object();
  for (const ParamInfo& info : params_table())
    if (info.name != "scene") json[std::string(info.name)] = setting_json(info, params);
  return json;
}

Json totals_json(const RenderReport& report) {
  double seconds = 0.0, cpu_seconds = 0.0;
  RayCounts rays;
  for (const auto* frames : {&report.frames, &report.sources})
    for (const FrameReport& frame : *frames) {
      seconds += frame.seconds;
      cpu_seconds += frame.cpu_seconds;
      add(frame.rays, rays);
    }
  return {{"seconds", seconds},
          {"cpu_seconds", cpu_seconds},
          {"write_seconds", report.write_seconds},
          {"setup_seconds", report.setup_seconds},
          {"frames", report.frames.size()},
          {"source_frames", report.sources.size()},
          {"rays", rays_json(rays)},
          {"peak_memory_bytes", report.peak_memory_bytes},
          {"threads", report.threads}};
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

Json to_json(const FrameReport& frame) {
  return {{"frame", frame.frame},
          {"kind", frame.kind},
          {"seconds", frame.seconds},
          {"cpu_seconds", frame.cpu_seconds},
          {"rays", rays_json(frame.rays)},
          {"missed_pixels", frame.missed_pixels},
          {"newly_visible_pixels", frame.newly_visible_pixels},
          {"not_covered_pixels", frame.not_covered_pixels},
          {"retraced_pixels", frame.retraced_pixels},
          {"reused_pixels", frame.reused_pixels},
          {"estimated_psnr_db", number_or_null(frame.estimated_psnr_db)},
          {"psnr_at_least_db", number_or_null(frame.psnr_at_least_db)},
          {"estimated_block_psnr_db", number_or_null(frame.estimated_block_psnr_db)},
          {"precompensation", precompensation_json(frame.precompensation)},
          {"kept", frame.kept}};
}

Json to_json(const RenderReport& report) {
  Json frames = Json::array();
  for (const FrameReport& frame : report.frames) frames.push_back(to_json(frame));
  return {{"version", version()},
          {"scene", report.scene},
          {"light", report.light},
          {"view", report.view},
          {"optics", optics_json(report.optics)},
          {"depth", depth_json(report.depth, report.depth_scale, report.optics)},
          {"precompensation", precompensation_json(report)},
          {"reuse", name_of(report.reuse)},
          {"settings", settings_json(report.params)},
          {"frames_per_second", report.frames_per_second},
          {"interrupted", report.interrupted},
          {"videos", report.videos},
          {"frames", std::move(frames)},
          {"totals", totals_json(report)}};
}

std::optional<FrameReport> frame_report_from_json(const Json& json) try {
  FrameReport frame;
  const auto is_count = [](const Json& n, std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
    return n.is_number_integer() && n.get<std::int64_t>() >= 0 && n.get<std::int64_t>() <= most;
  };
  for (const char* key : {"missed_pixels", "newly_visible_pixels", "not_covered_pixels", "retraced_pixels", "reused_pixels"})
    if (!is_count(json.at(key))) return std::nullopt;
  for (const char* key : {"primary", "shadow", "reflection", "indirect"})
    if (!is_count(json.at("rays").at(key))) return std::nullopt;
  if (!is_count(json.at("frame"), std::numeric_limits<int>::max())) return std::nullopt;
  json.at("frame").get_to(frame.frame);
  json.at("kind").get_to(frame.kind);
  json.at("seconds").get_to(frame.seconds);
  json.at("cpu_seconds").get_to(frame.cpu_seconds);
  const Json& rays = json.at("rays");
  rays.at("primary").get_to(frame.rays.primary);
  rays.at("shadow").get_to(frame.rays.shadow);
  rays.at("reflection").get_to(frame.rays.reflection);
  rays.at("indirect").get_to(frame.rays.indirect);
  json.at("missed_pixels").get_to(frame.missed_pixels);
  json.at("newly_visible_pixels").get_to(frame.newly_visible_pixels);
  json.at("not_covered_pixels").get_to(frame.not_covered_pixels);
  json.at("retraced_pixels").get_to(frame.retraced_pixels);
  json.at("reused_pixels").get_to(frame.reused_pixels);
  frame.estimated_psnr_db = number_or_none(json.at("estimated_psnr_db"));
  frame.psnr_at_least_db = number_or_none(json.at("psnr_at_least_db"));
  frame.estimated_block_psnr_db = number_or_none(json.at("estimated_block_psnr_db"));
  frame.precompensation = precompensation_from_json(json.at("precompensation"));
  const bool is_measured = frame.estimated_psnr_db && frame.psnr_at_least_db && frame.estimated_block_psnr_db;
  if (frame.kind == "shared" && !is_measured) return std::nullopt;
  return frame;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

}  // namespace lippmann
