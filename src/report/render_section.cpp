#include "report/render_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/frame_ranges.hpp"
#include "core/json_text.hpp"
#include "core/printable.hpp"
#include "job/settings_command.hpp"
#include "lippmann/core/error.hpp"
#include "report/figure_text.hpp"
#include "report/frame_charts.hpp"
#include "report/frame_table.hpp"
#include "report/html.hpp"
#include "report/render_summary.hpp"

namespace lippmann {
namespace {

std::string subtitle_of(const RenderFigures& render) {
  return render.scene + (render.reuse.empty() ? "" : ", reuse " + render.reuse);
}

std::string tiles_html(const RenderFigures& render) {
  std::string html = "<dl class=\"tiles\">";
  for (const SummaryFigure& figure : render_summary(render))
    html += fmt::format("<div><dt>{}</dt><dd><b>{}</b><span>{}</span></dd></div>", escaped(figure.name), escaped(figure.value),
                        escaped(figure.why));
  return html + "</dl>\n";
}

std::string command_html(const RenderFigures& render) {
  if (render.settings.empty()) return {};
  const std::string again = fmt::format("lippmann render {}", shell_word((render.report.parent_path() / "job.toml").string()));
  return fmt::format(
      "<h3>Command</h3><pre>{}</pre><p class=\"note\">Settings that differ from the defaults. The folder's "
      "<code>job.toml</code> "
      "has the same: <code>{}</code></p>\n",
      escaped(command_of_settings(render.scene, render.settings)), escaped(again));
}

std::string about_html(const RenderFigures& render) {
  std::string html;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, escaped(value));
  };
  add("scene", render.scene), add("reuse in effect", render.reuse), add("version", render.version);
  add("view", render.view), add("light", render.light);
  return "<dl class=\"about\">" + html + "</dl>\n";
}

struct MachineRow {
  std::size_t runs = 0, frames = 0;
  double setup_seconds = 0.0, write_seconds = 0.0, peak_memory_bytes = 0.0;
};

std::size_t frames_in(const std::string& ranges) {
  try {
    return ranges.empty() ? 0 : frames_of(read_frames(ranges, {})).size();
  } catch (const Error&) {
    return 0;  // an untrusted report may contain any text
  }
}

std::string machines_html(const RenderFigures& render) {
  std::map<std::tuple<std::string, std::string, int>, MachineRow> rows;
  for (const RunFigures& run : render.runs) {
    MachineRow& row = rows[{run.host, run.cpu, run.threads}];
    ++row.runs, row.frames += frames_in(run.frames);
    row.setup_seconds += run.setup_seconds, row.write_seconds += run.write_seconds;
    row.peak_memory_bytes = std::max(row.peak_memory_bytes, run.peak_memory_bytes);
  }
  HtmlTable table{{"machine", "processor", "threads", "runs", "frames", "peak memory", "set-up", "writing"}};
  for (const auto& [key, row] : rows) {
    const auto& [host, cpu, threads] = key;
    table.rows.push_back({escaped(host.empty() ? kNotKnown : host), escaped(cpu.empty() ? kNotKnown : cpu),
                          fmt::format("{}", threads), fmt::format("{}", row.runs), fmt::format("{}", row.frames),
                          memory_text(row.peak_memory_bytes), seconds_text(row.setup_seconds),
                          seconds_text(row.write_seconds)});
  }
  if (rows.empty()) return {};
  const char* mixed =
      rows.size() > 1 ? "<p class=\"note\">Times of different machines are not comparable: compare frames of one machine.</p>"
                      : "";
  return "<h3>Machine</h3>" + table_html(table) + mixed;
}

std::string pictures_html(const Thumbnails& thumbnails) {
  std::string html;
  for (const Thumbnail& picture : thumbnails.pictures)
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"Frame {}, the view in the middle\" "
        "style=\"aspect-ratio:{:.4f}\"><figcaption>{}</figcaption>"
        "</figure>",
        picture.source, escaped(picture.label), picture.aspect, escaped(picture.label));
  if (!html.empty()) html = "<div class=\"pictures\">" + html + "</div>";
  if (!thumbnails.problem.empty())
    html += fmt::format("<p class=\"note\">Some pictures cannot be shown: {}</p>", escaped(thumbnails.problem));
  return html.empty() ? html : "<h3>Middle views</h3>" + html + '\n';
}

std::string settings_html(const RenderFigures& render) {
  HtmlTable table{{"setting", "value"}};
  for (const auto& [name, value] : render.settings.items())
    if (!value.is_null() && !(value.is_array() && value.empty()))
      table.rows.push_back({escaped(name), escaped(value.is_string() ? value.get<std::string>() : json_to_text(value, -1))});
  if (table.rows.empty()) return {};
  return "<details><summary>All settings</summary>" + table_html(table) + "</details>\n";
}

}  // namespace

std::string render_section(const RenderFigures& render, const Thumbnails& thumbnails) {
  const std::string charts =
      charts_html({psnr_chart(render), origin_chart(render), time_chart(render), saving_chart(render), ray_chart(render)});
  return fmt::format("<section><h2>{} <small>{}</small></h2>{}{}{}{}{}{}{}{}{}</section>\n", escaped(render.title),
                     escaped(subtitle_of(render)), sentences_html(render.missing), tiles_html(render),
                     pictures_html(thumbnails), charts.empty() ? "" : "<h3>Frame by frame</h3>" + charts, frame_table(render),
                     command_html(render), about_html(render), machines_html(render), settings_html(render));
}

}  // namespace lippmann
