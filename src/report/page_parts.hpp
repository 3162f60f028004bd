// The files that the build puts into the program: src/report/page.css and the script of web/src/report.ts as built in web/dist.
#pragma once

#include <string_view>

namespace lippmann {

std::string_view page_style();

/// Draws the charts of a page (report/chart.hpp).
std::string_view page_script();
/// The script's SHA-256 in base64, for a content security policy.
std::string_view page_script_hash();

}  // namespace lippmann
