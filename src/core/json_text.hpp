// Parses and writes JSON. nlohmann's parser and writer are compiled only here, because each takes seconds to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"

namespace lippmann {

/// Keeps the order of keys. For invalid text, is_discarded() of the result is true.
nlohmann::ordered_json json_from_text(std::string_view text);

/// Returns the error in invalid text. It names `where`, the member, such as "frames[3].matrix[0][1]", and the invalid word.
Error json_error(std::string_view text, const std::string& where);

/// Writes JSON on one line if `indent` is below 0. Bytes that are not UTF-8 become U+FFFD.
std::string json_to_text(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace lippmann
