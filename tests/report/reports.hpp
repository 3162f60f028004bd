// Makes reports of renders with known contents.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lippmann/frames/frame_report.hpp"
#include "report/render_figures.hpp"

namespace lippmann::test {

using OrderedJson = nlohmann::ordered_json;

inline constexpr double kPixels = 100.0;

/// Returns a key frame that took 2 CPU seconds and 400 rays.
FrameReport key_frame(int number);
/// Returns a frame that took 0.5 CPU seconds. Of its 100 pixels, 80 were reused and 15 traced.
FrameReport in_between_frame(int number);

OrderedJson report_of_frames(const std::string& reuse, const std::vector<FrameReport>& frames);

RenderFigures figures_of(const OrderedJson& report);

std::filesystem::path write_report_text(const std::filesystem::path& folder, const std::string& text);

std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace lippmann::test
