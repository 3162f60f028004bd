// Makes a page about renders and benchmarks: one HTML file that opens from disk and loads no other file. Untrusted names are
// escaped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct ReportPage {
  std::string html;
  /// Sentences on missing values. Each begins with the name of the render.
  std::vector<std::string> missing;
};

/// `inputs` are folders of renders, report.json files, or JSON files that `bench` printed. Several renders are compared with
/// the first. Throws Error naming an input that is none of these.
ReportPage make_report_page(const std::vector<std::filesystem::path>& inputs, const Context& context);

std::filesystem::path default_report_file(const std::vector<std::filesystem::path>& inputs);

/// Makes the folder if necessary. Throws Error naming the file if it cannot be written, or if it exists and is not a report
/// page.
void write_report_page(const ReportPage& page, const std::filesystem::path& file);

}  // namespace lippmann
