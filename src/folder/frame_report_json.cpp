#include "folder/frame_report_json.hpp"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> number_or_none(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

/// Reports of earlier versions lack some figures.
std::optional<double> number_if_any(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? std::nullopt : number_or_none(*found);
}

std::optional<Precompensation> precompensation_from_json(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Precompensation{json.at("clipped_share").get<double>(), json.at("largest_residual").get<double>()};
}

}  // namespace

Json to_json(const RayCounts& rays) {
  return {{"primary", rays.primary}, {"shadow", rays.shadow}, {"reflection", rays.reflection}, {"indirect", rays.indirect}};
}

Json to_json(const std::optional<Precompensation>& done) {
  if (!done) return nullptr;
  return {{"clipped_share", done->clipped_share}, {"largest_residual", done->largest_residual}};
}

Json to_json(const FrameReport& frame) {
  return {{"frame", frame.frame},
          {"kind", frame.kind},
          {"seconds", frame.seconds},
          {"cpu_seconds", frame.cpu_seconds},
          {"rays", to_json(frame.rays)},
          {"missed_pixels", frame.missed_pixels},
          {"newly_visible_pixels", frame.newly_visible_pixels},
          {"not_covered_pixels", frame.not_covered_pixels},
          {"retraced_pixels", frame.retraced_pixels},
          {"reused_pixels", frame.reused_pixels},
          {"estimated_psnr_db", number_or_null(frame.estimated_psnr_db)},
          {"psnr_at_least_db", number_or_null(frame.psnr_at_least_db)},
          {"psnr_at_most_db", number_or_null(frame.psnr_at_most_db)},
          {"precompensation", to_json(frame.precompensation)},
          {"kept", frame.kept}};
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
  // Earlier versions wrote "shared" for path-traced frames whose soft light came from a cache.
  if (frame.kind == "shared") frame.kind = "full";
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
  frame.psnr_at_most_db = number_if_any(json, "psnr_at_most_db");
  frame.precompensation = precompensation_from_json(json.at("precompensation"));
  return frame;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

}  // namespace lippmann
