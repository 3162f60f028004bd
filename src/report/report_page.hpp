// Makes a page of figures of renders and benchmarks: one HTML file that opens from disk, loads nothing, and runs one script to
// draw the charts.
//
// The page contains images of some frames and the source of each figure. Untrusted names are escaped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct ReportPage {
  std::string html;
  std::vector<std::string> missing;  ///< sentences on missing figures, each beginning with the name of its render
};

/// inputs: one or more folders of renders, report.json files, or JSON files printed by `bench`. With several renders, each is
/// compared with the first. Throws Error naming an input of another kind.
ReportPage make_report_page(const std::vector<std::filesystem::path>& inputs, const Context& context);

/// Returns the default file: in the folder if there is only one input, otherwise in the working folder.
std::filesystem::path default_report_file(const std::vector<std::filesystem::path>& inputs);

/// Writes the page and creates its folder. Throws Error naming the file, also if it exists and is not a report page.
void write_report_page(const ReportPage& page, const std::filesystem::path& file);

}  // namespace lippmann
