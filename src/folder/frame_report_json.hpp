// Converts the figures of a frame to and from JSON, for journals and report.json (docs/reference/formats.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

nlohmann::ordered_json to_json(const RayCounts& rays);
nlohmann::ordered_json to_json(const std::optional<Precompensation>& done);
nlohmann::ordered_json to_json(const FrameReport& frame);

/// The report may come from an earlier version. Returns nullopt if a value is missing or has the wrong type.
std::optional<FrameReport> frame_report_from_json(const nlohmann::ordered_json& json);

}  // namespace lippmann
