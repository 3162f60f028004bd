// Makes reports of renders with known figures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"
#include "report/render_figures.hpp"

namespace lippmann::test {

using OrderedJson = nlohmann::ordered_json;

/// number of pixels of the panel, 10 x 10
inline constexpr double kPixels = 100.0;

/// Returns the report of a key frame that took 2 CPU seconds and 400 rays.
FrameReport key_frame(int number);
/// Returns the report of an in-between frame that took 0.5 CPU seconds. Of its 100 pixels, 80 were reused and 15 were traced.
FrameReport in_between_frame(int number);

/// Returns the report of a finished render on one machine. `reuse` is the kind of reuse between frames.
OrderedJson report_of_frames(const std::string& reuse, const std::vector<FrameReport>& frames);

RenderFigures figures_of(const OrderedJson& report);

/// Creates the folder with a file report.json that contains `text`, and returns the folder.
std::filesystem::path write_report_text(const std::filesystem::path& folder, const std::string& text);

/// Returns how often `part` occurs in `text`.
std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace lippmann::test
