// Files that the build embeds: src/report/page.css, and the script of web/src/report.ts (from web/dist).
#pragma once

#include <string_view>

namespace lippmann {

std::string_view page_style();

std::string_view page_script();
/// SHA-256 of the script in base64, for the content security policy.
std::string_view page_script_hash();

}  // namespace lippmann
