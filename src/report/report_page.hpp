// Makes a page with the figures of renders and benchmarks. The page is one HTML file that opens from disk and loads no other
// file. It runs one script, which draws the charts.
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
  /// Sentences on missing figures. Each begins with the name of the render.
  std::vector<std::string> missing;
};

/// Makes the page. `inputs` are one or more folders of renders, report.json files, or JSON files that `bench` printed. If there
/// are several renders, each is compared with the first. Throws Error that names an input that is none of these.
ReportPage make_report_page(const std::vector<std::filesystem::path>& inputs, const Context& context);

/// Returns the default path of the page. The page is in the folder of the input if there is only one input, and otherwise in
/// the working folder.
std::filesystem::path default_report_file(const std::vector<std::filesystem::path>& inputs);

/// Writes the page, and makes its folder if necessary. Throws Error that names the file if it cannot be written, or if it
/// exists and is not a report page.
void write_report_page(const ReportPage& page, const std::filesystem::path& file);

}  // namespace lippmann
