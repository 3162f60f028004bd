// Reports of renders with known figures, for tests.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"
#include "report/render_figures.hpp"

namespace lippmann::test {

using OrderedJson = nlohmann::ordered_json;

/// Pixels of a panel of 10 x 10.
inline constexpr double kPixels = 100.0;

/// Returns a key frame with 2 CPU seconds and 400 rays.
FrameReport key_frame(int number);
/// Returns a frame made from others: 0.5 CPU seconds; of its 100 pixels 80 were reused, 15 traced.
FrameReport in_between_frame(int number);

/// Returns the report of a finished render with this kind of reuse, by one machine.
OrderedJson report_of_frames(const std::string& reuse, const std::vector<FrameReport>& frames);

RenderFigures figures_of(const OrderedJson& report);

/// Makes the folder with a report.json of this text, and returns it.
std::filesystem::path write_report_text(const std::filesystem::path& folder, const std::string& text);

/// Returns how often a part occurs.
std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace lippmann::test
