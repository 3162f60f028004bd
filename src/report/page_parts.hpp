// Files that the build embeds: src/report/page.css, and the script of web/src/report.ts (from web/dist).
#pragma once

#include <string_view>

namespace lippmann {

std::string_view page_style();

/// Returns the script that draws the charts of a page (report/chart.hpp).
std::string_view page_script();
/// Returns the script's SHA-256 in base64, for the content security policy.
std::string_view page_script_hash();

}  // namespace lippmann
