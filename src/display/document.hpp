// TOML and JSON of foreign origin as one kind of tree, within limits. Private to this part.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace lippmann {

/// Files above this are refused.
inline constexpr std::size_t kMaxDocumentBytes = 1 << 20;

/// An object; members that are {"value": x} have become x. Throw Error naming `where` (and the line) for text that is no such
/// document, and for one that is too large or nested too deep. Dates, of which no display has any, become null.
nlohmann::ordered_json parse_toml(std::string_view text, const std::string& where);
nlohmann::ordered_json parse_json(std::string_view text, const std::string& where);

}  // namespace lippmann
