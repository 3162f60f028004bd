// A page of figures of renders and benchmarks: one file of HTML that opens from a disk, loads nothing, and runs one script,
// which draws the charts.
//
// It holds pictures of some frames and says where each figure comes from. Names of foreign origin are shown as they are, and
// cannot become anything else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct ReportPage {
  std::string html;
  std::vector<std::string> missing;  ///< sentences: what the page says that it lacks, beginning with whose it is
};

/// `inputs`: at least one; folders of renders, their report.json, or what `bench` has printed as JSON. Several renders are
/// compared with the first. Throws Error naming the input that is none of these.
ReportPage make_report_page(const std::vector<std::filesystem::path>& inputs, const Context& context);

/// Where the page goes if nobody says: into the one folder, else into the working folder.
std::filesystem::path default_report_file(const std::vector<std::filesystem::path>& inputs);

/// Writes the page, and makes its folder. Throws Error naming the file, also where another file has its name.
void write_report_page(const ReportPage& page, const std::filesystem::path& file);

}  // namespace lippmann
