#include "report/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "report/frame_origins.hpp"
#include "report/html.hpp"

namespace lippmann {
namespace {

struct Column {
  std::string name;
  std::function<std::string(const FrameReport&)> cell;
};

std::string number_cell(double value, int digits) {
  return value == 0.0 ? std::string("0") : fmt::format("{:.{}f}", value, digits);
}

std::string decibels(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : std::string(); }

std::vector<Column> frame_columns(const RenderFigures& render) {
  std::vector<Column> columns{{"frame", [](const auto& frame) { return fmt::format("{}", frame.frame); }},
                              {"kind", [](const auto& frame) { return escaped(frame.kind); }},
                              {"CPU s", [](const auto& frame) { return number_cell(frame.cpu_seconds, 3); }},
                              {"wall s", [](const auto& frame) { return number_cell(frame.seconds, 3); }}};
  const std::optional<double> traced = traced_cpu_seconds(render);
  columns.push_back({"saved %", [traced](const FrameReport& frame) {
                       const auto saved = is_traced_whole(frame) ? std::nullopt : saving(frame.cpu_seconds, traced);
                       return saved ? fmt::format("{:.1f}", 100.0 * *saved) : std::string();
                     }});
  const auto add_rays = [&](const char* name, std::uint64_t RayCounts::*kind) {
    columns.push_back(
        {name, [kind](const FrameReport& frame) { return number_cell(static_cast<double>(frame.rays.*kind) * 1e-6, 3); }});
  };
  add_rays("primary M", &RayCounts::primary), add_rays("shadow M", &RayCounts::shadow);
  add_rays("mirrored M", &RayCounts::reflection), add_rays("indirect M", &RayCounts::indirect);
  for (std::size_t i = 0; i < kOriginNames.size(); ++i)
    columns.push_back({fmt::format("{} %", kOriginNames[i]), [i, &render](const FrameReport& frame) {
                         const auto shares = origins_of(frame, render);
                         return shares ? number_cell(100.0 * (*shares)[i], 2) : std::string();
                       }});
  const auto add_pixels = [&](const char* name, std::uint64_t FrameReport::*pixels) {
    columns.push_back({name, [pixels](const FrameReport& frame) { return fmt::format("{}", frame.*pixels); }});
  };
  add_pixels("missed", &FrameReport::missed_pixels), add_pixels("newly visible", &FrameReport::newly_visible_pixels);
  add_pixels("not covered", &FrameReport::not_covered_pixels);
  columns.push_back({"PSNR dB", [](const auto& frame) { return decibels(frame.estimated_psnr_db); }});
  columns.push_back({"at least dB", [](const auto& frame) { return decibels(frame.psnr_at_least_db); }});
  columns.push_back({"at most dB", [](const auto& frame) { return decibels(frame.psnr_at_most_db); }});
  return columns;
}

}  // namespace

std::string frame_table(const RenderFigures& render) {
  HtmlTable table;
  table.rows.resize(render.frames.size());
  for (const Column& column : frame_columns(render)) {
    std::vector<std::string> cells;
    for (const FrameReport& frame : render.frames) cells.push_back(column.cell(frame));
    if (std::all_of(cells.begin(), cells.end(), [](const auto& cell) { return cell.empty() || cell == "0"; }) &&
        column.name != "frame")
      continue;
    table.head.push_back(escaped(column.name));
    for (std::size_t i = 0; i < cells.size(); ++i) table.rows[i].push_back(std::move(cells[i]));
  }
  if (render.frames.empty()) return {};
  return fmt::format("<details><summary>Figures of every frame ({})</summary>{}</details>\n", render.frames.size(),
                     table_html(table));
}

}  // namespace lippmann
