// Parses untrusted TOML and JSON into trees of the same type. Limits size and nesting. Private to src/display.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace lippmann {

inline constexpr std::size_t kMaxDocumentBytes = 1 << 20;

/// Parse a text and return an object. Members of the form {"value": x} become x. Dates become null. Throw Error naming `where`
/// (and the line) if the text is invalid, too large or nested too deep.
nlohmann::ordered_json parse_toml(std::string_view text, const std::string& where);
nlohmann::ordered_json parse_json(std::string_view text, const std::string& where);

}  // namespace lippmann
