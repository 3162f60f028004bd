#include "report/reports.hpp"

#include <fstream>

#include "folder/frame_report_json.hpp"
#include "optics/optics_json.hpp"

namespace lippmann::test {
namespace {

OrderedJson totals_of(const std::vector<FrameReport>& frames) {
  double cpu_seconds = 0.0;
  for (const FrameReport& frame : frames) cpu_seconds += frame.cpu_seconds;
  return {{"cpu_seconds", cpu_seconds}, {"source_frames", 0}, {"setup_seconds", 0.25}, {"peak_memory_bytes", 50'000'000}};
}

OrderedJson one_run() {
  return {{"host", "workbench"}, {"cpu", "Example 9000"}, {"unit", ""},
          {"frames", "0-2"},     {"setup_seconds", 0.25}, {"write_seconds", 0.5},
          {"threads", 2},        {"source_frames", 0},    {"peak_memory_bytes", 50'000'000}};
}

Optics small_panel() {
  Optics optics;
  optics.panel = {10, 10, 0.25f};
  optics.model = LenticularSheet{};
  return optics;
}

}  // namespace

FrameReport key_frame(int number) {
  FrameReport frame;
  frame.frame = number, frame.kind = "key", frame.seconds = 1.0, frame.cpu_seconds = 2.0;
  frame.rays = {100, 200, 60, 40};
  return frame;
}

FrameReport in_between_frame(int number) {
  FrameReport frame;
  frame.frame = number, frame.kind = "in-between", frame.seconds = 0.3, frame.cpu_seconds = 0.5;
  frame.rays = {15, 30, 9, 6};
  frame.reused_pixels = 80, frame.retraced_pixels = 15, frame.missed_pixels = 7;
  return frame;
}

OrderedJson report_of_frames(const std::string& reuse, const std::vector<FrameReport>& frames) {
  OrderedJson list = OrderedJson::array();
  for (const FrameReport& frame : frames) list.push_back(to_json(frame));
  return {{"version", "0.2.0"},
          {"scene", "room"},
          {"optics", optics_json(small_panel())},
          {"reuse", reuse},
          {"settings", {{"spp", 4}, {"min-psnr", nullptr}}},
          {"frames_per_second", 24.0},
          {"interrupted", false},
          {"frames", list},
          {"runs", {one_run()}},
          {"totals", totals_of(frames)}};
}

RenderFigures figures_of(const OrderedJson& report) { return render_figures(report, "somewhere/report.json"); }

std::filesystem::path write_report_text(const std::filesystem::path& folder, const std::string& text) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "report.json") << text;
  return folder;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace lippmann::test
