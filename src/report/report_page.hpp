// Makes a page with the figures of renders and benchmarks. It is one HTML file that opens from disk, loads no other file, and
// runs one script, which draws the charts.
//
// The page contains images of some frames, and states where each figure comes from. Untrusted names are escaped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct ReportPage {
  std::string html;
  std::vector<std::string> missing;  ///< sentences on missing figures, each beginning with the name of the render
};

/// Makes the page. inputs: one or more folders of renders, report.json files, or JSON files printed by `bench`. With several
/// renders, each is compared with the first. Throws Error naming an input that is none of these.
ReportPage make_report_page(const std::vector<std::filesystem::path>& inputs, const Context& context);

/// Returns the default path of the page: in the input's folder if there is only one input, otherwise in the working folder.
std::filesystem::path default_report_file(const std::vector<std::filesystem::path>& inputs);

/// Writes the page, and makes its folder if necessary. Throws Error naming the file, also if it exists and is not a report
/// page.
void write_report_page(const ReportPage& page, const std::filesystem::path& file);

}  // namespace lippmann
