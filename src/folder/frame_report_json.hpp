// The figures of a frame as JSON, in a folder's journal and in report.json; docs/reference/formats.md explains every key.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

nlohmann::ordered_json to_json(const RayCounts& rays);
nlohmann::ordered_json to_json(const std::optional<Precompensation>& done);
nlohmann::ordered_json to_json(const FrameReport& frame);

/// The inverse, also for reports of earlier versions; none if anything is missing or of the wrong type.
std::optional<FrameReport> frame_report_from_json(const nlohmann::ordered_json& json);

}  // namespace lippmann
