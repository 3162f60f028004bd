#include "report/render_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "folder/frame_report_json.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/optics.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns 0 unless the value is a finite number above 0.
double number_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  const double value = found != json.end() && found->is_number() ? found->get<double>() : 0.0;
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

bool flag_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_boolean() && found->get<bool>();
}

std::string folder_name(const fs::path& report) {
  const fs::path folder = fs::absolute(report).lexically_normal().parent_path();
  return folder.has_filename() ? folder.filename().string() : folder.string();
}

RunFigures run_figures(const Json& run) {
  RunFigures figures;
  figures.host = text_at(run, "host"), figures.cpu = text_at(run, "cpu");
  figures.unit = text_at(run, "unit"), figures.frames = text_at(run, "frames");
  figures.setup_seconds = number_at(run, "setup_seconds"), figures.write_seconds = number_at(run, "write_seconds");
  figures.peak_memory_bytes = number_at(run, "peak_memory_bytes");
  figures.threads = static_cast<int>(std::min(number_at(run, "threads"), 1e6));
  return figures;
}

void read_frame_list(const Json& list, RenderFigures& figures) {
  std::size_t left_out = 0;
  for (const Json& json : list)
    if (const std::optional<FrameReport> frame = frame_report_from_json(json))
      figures.frames.push_back(*frame);
    else
      ++left_out;
  std::stable_sort(figures.frames.begin(), figures.frames.end(),
                   [](const auto& a, const auto& b) { return a.frame < b.frame; });
  if (left_out > 0)
    figures.missing.push_back(fmt::format("{} frame{} of the report lack{} figures and {} left out.", left_out,
                                          left_out == 1 ? "" : "s", left_out == 1 ? "s" : "", left_out == 1 ? "is" : "are"));
  if (list.empty()) figures.missing.emplace_back("No frame is finished: the report lists none.");
}

void read_runs(const Json& report, RenderFigures& figures) {
  if (const auto runs = report.find("runs"); runs != report.end() && runs->is_array())
    for (const Json& run : *runs)
      if (run.is_object()) figures.runs.push_back(run_figures(run));
  if (figures.runs.empty())
    figures.missing.emplace_back("No run has recorded its end: the machine, its memory and the set-up time are unknown.");
}

void read_totals(const Json& report, RenderFigures& figures) {
  for (const FrameReport& frame : figures.frames) figures.cpu_seconds += frame.cpu_seconds;
  const auto totals = report.find("totals");
  if (totals == report.end() || !totals->is_object()) {
    figures.missing.emplace_back("The totals are missing, including the time of source frames.");
    return;
  }
  figures.cpu_seconds = std::max(figures.cpu_seconds, number_at(*totals, "cpu_seconds"));
  figures.source_frames = number_at(*totals, "source_frames");
  figures.setup_seconds = number_at(*totals, "setup_seconds"), figures.write_seconds = number_at(*totals, "write_seconds");
  figures.peak_memory_bytes = number_at(*totals, "peak_memory_bytes");
}

void read_optics(const Json& report, const fs::path& path, RenderFigures& figures) {
  try {
    const Vec2i film = film_size(optics_from_json(report.at("optics"), path.string()));
    figures.pixels = static_cast<double>(film.x) * film.y;
  } catch (const std::exception& problem) {
    figures.missing.push_back(
        fmt::format("Shares of pixels are unknown because the optics cannot be read: {}", problem.what()));
  }
}

}  // namespace

RenderFigures render_figures(const Json& report, const fs::path& path) {
  const auto frames = report.find("frames");
  if (frames == report.end() || !frames->is_array())
    throw Error(path.string(), "lists no frames", "the report.json that `lippmann render` writes");
  RenderFigures figures;
  figures.report = path, figures.title = folder_name(path);
  figures.version = text_at(report, "version"), figures.scene = text_at(report, "scene");
  figures.light = text_at(report, "light"), figures.view = text_at(report, "view"), figures.reuse = text_at(report, "reuse");
  if (const auto settings = report.find("settings"); settings != report.end() && settings->is_object())
    figures.settings = *settings;
  else
    figures.missing.emplace_back("The settings are missing: the command is unknown.");
  if (const double rate = number_at(report, "frames_per_second"); rate > 0.0) figures.frames_per_second = rate;
  figures.interrupted = flag_at(report, "interrupted");
  if (figures.interrupted)
    figures.missing.emplace_back("The render was stopped or is still running: these are its finished frames.");
  read_frame_list(*frames, figures);
  read_runs(report, figures);
  read_totals(report, figures);
  read_optics(report, path, figures);
  return figures;
}

}  // namespace lippmann
