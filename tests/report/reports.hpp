// Reports as renders leave them, of frames whose figures are known.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"
#include "report/render_figures.hpp"

namespace lippmann::test {

using OrderedJson = nlohmann::ordered_json;

/// Of a panel of 10 x 10 pixels.
inline constexpr double kPixels = 100.0;

/// A key frame: 2 CPU seconds, 400 rays.
FrameReport key_frame(int number);
/// Made from others: 0.5 CPU seconds; of its 100 pixels 80 were reused, 15 traced.
FrameReport in_between_frame(int number);

/// A finished render with that kind of reuse, by one machine.
OrderedJson report_of_frames(const std::string& reuse, const std::vector<FrameReport>& frames);

RenderFigures figures_of(const OrderedJson& report);

/// The folder, made, with a report.json of that text.
std::filesystem::path write_report_text(const std::filesystem::path& folder, const std::string& text);

/// How often a part occurs.
std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace lippmann::test
