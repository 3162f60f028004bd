// What the report.json of a render says of its frames that a page shows: which were traced, and how near the others came.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace lippmann {

struct FrameFacts {
  std::string kind = {};               ///< full, key, in-between or shared; empty: the report does not say
  std::optional<double> psnr_db = {};  ///< as estimated while rendering; none: exact, or not estimated
};

struct ReportFacts {
  std::string scene = {};
  std::map<int, FrameFacts> frames = {};
};

/// Of the report.json in `folder`. What is missing or damaged says nothing: pictures are shown without.
ReportFacts read_report_facts(const std::filesystem::path& folder);

}  // namespace lippmann
