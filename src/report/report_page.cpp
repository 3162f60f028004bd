#include "report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "report/bench_section.hpp"
#include "report/comparison_section.hpp"
#include "report/html.hpp"
#include "report/page_parts.hpp"
#include "report/render_section.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kAccepted = "the folder of a render, its report.json, or what `lippmann-bench` prints as JSON";
// Largest input in bytes: room for 400,000 frames of about 600 bytes each.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMaxPictures = 6;
/// Every report page contains this text. An existing file without this text is not overwritten.
constexpr std::string_view kMark = "<meta name=\"generator\" content=\"lippmann report\">";

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

fs::path file_of(const fs::path& input) { return is_folder(input) ? input / "report.json" : input; }

Json read_json(const fs::path& file) {
  Json json = json_from_text(read_recorded_text(file, kMostBytes, kAccepted));
  if (json.is_discarded()) throw Error(file.string(), "is not JSON, or is truncated", kAccepted);
  if (!json.is_object()) throw Error(file.string(), "is not a JSON object", kAccepted);
  return json;
}

/// Returns the titles of the renders. Renders with equal titles are named by their paths.
std::vector<std::string> names_of(const std::vector<RenderFigures>& renders) {
  std::vector<std::string> names;
  for (const RenderFigures& render : renders) {
    const auto same =
        std::count_if(renders.begin(), renders.end(), [&](const auto& other) { return other.title == render.title; });
    names.push_back(same > 1 ? render.report.string() : render.title);
  }
  return names;
}

std::string title_of(const std::vector<std::string>& names, std::size_t benchmarks) {
  std::string title;
  for (const std::string& name : names) title += (title.empty() ? "" : ", ") + name;
  return title.empty() ? (benchmarks == 1 ? "Benchmark" : "Benchmarks") : title;
}

std::string page_html(const std::string& heading, const std::string& title, const std::string& body, bool has_charts) {
  const std::string script = has_charts ? fmt::format("<script>{}</script>\n", page_script()) : std::string();
  return fmt::format(R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{}'">
<meta name="color-scheme" content="light dark">
{}
<title>{} - Lippmann</title>
<style>
{}</style>
</head>
<body>
<header><h1>{}</h1></header>
<main>
{}</main>
<footer>Written by lippmann {}. Times are of rendering, without writing files; CPU time is of all threads together.</footer>
{}</body>
</html>
)",
                     page_script_hash(), kMark, escaped(title), page_style(), escaped(heading), body, version(), script);
}

void require_own_report(const fs::path& file) {
  if (!is_regular_file_there(file)) return;
  if (read_file_text(file, kMostBytes).find(kMark) == std::string::npos)
    throw Error(file.string(), "exists and is not a report page, so it is not replaced",
                "a new name, or the name of a report page");
}

}  // namespace

ReportPage make_report_page(const std::vector<fs::path>& inputs, const Context& context) {
  std::vector<RenderFigures> renders;
  std::string benchmarks;
  std::size_t benchmark_count = 0;
  for (const fs::path& input : inputs) {
    const fs::path file = file_of(input);
    const Json json = read_json(file);
    if (is_bench_result(json))
      benchmarks += bench_section(json, file), ++benchmark_count;
    else
      renders.push_back(render_figures(json, file));
  }
  ReportPage page;
  const std::vector<std::string> names = names_of(renders);
  std::string body = renders.size() > 1 ? comparison_section(renders, names) : std::string();
  for (std::size_t i = 0; i < renders.size() && !context.cancelled; ++i) {
    body += render_section(renders[i], read_thumbnails(renders[i].report, kMaxPictures, context));
    for (const std::string& sentence : renders[i].missing) page.missing.push_back(fmt::format("{}: {}", names[i], sentence));
  }
  page.html = page_html(renders.empty() ? "Benchmark report" : "Render report", title_of(names, benchmark_count),
                        body + benchmarks, !renders.empty());
  return page;
}

fs::path default_report_file(const std::vector<fs::path>& inputs) {
  return inputs.size() == 1 && is_folder(inputs.front()) ? inputs.front() / "report.html" : fs::path("report.html");
}

void write_report_page(const ReportPage& page, const fs::path& file) {
  require_own_report(file);
  const NewFolder folder(file.parent_path());
  write_file_atomically(file, std::as_bytes(std::span(page.html)));
}

}  // namespace lippmann
