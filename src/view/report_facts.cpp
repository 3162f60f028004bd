#include "view/report_facts.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/json_text.hpp"
#include "core/regular_file.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMostReportBytes = std::uintmax_t{256} << 20;
constexpr std::array<std::string_view, 4> kFrameKinds{"full", "key", "in-between", "shared"};

Json json_of(const fs::path& path) {
  std::error_code problem;
  if (!is_regular_file_there(path) || fs::file_size(path, problem) > kMostReportBytes || problem) return {};
  std::ifstream file(path, std::ios::binary);
  return json_from_text(std::string{std::istreambuf_iterator<char>(file), {}});
}

FrameFacts facts_of(const Json& frame) {
  FrameFacts facts;
  if (const auto kind = frame.find("kind"); kind != frame.end() && kind->is_string())
    for (const std::string_view known : kFrameKinds)
      if (*kind == known) facts.kind = known;
  if (const auto psnr = frame.find("estimated_psnr_db"); psnr != frame.end() && psnr->is_number())
    if (const double value = psnr->get<double>(); std::isfinite(value)) facts.psnr_db = value;
  return facts;
}

}  // namespace

ReportFacts read_report_facts(const fs::path& folder) {
  ReportFacts facts;
  const Json report = json_of(folder / "report.json");
  if (!report.is_object()) return facts;
  if (const auto scene = report.find("scene"); scene != report.end() && scene->is_string()) facts.scene = *scene;
  const auto frames = report.find("frames");
  if (frames == report.end() || !frames->is_array()) return facts;
  for (const Json& frame : *frames) {
    if (!frame.is_object()) continue;
    const auto number = frame.find("frame");
    if (number != frame.end() && number->is_number_integer() && number->get<std::int64_t>() >= 0 &&
        number->get<std::int64_t>() < (std::int64_t{1} << 30))
      facts.frames[number->get<int>()] = facts_of(frame);
  }
  return facts;
}

}  // namespace lippmann
