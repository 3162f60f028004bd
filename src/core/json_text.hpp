// JSON from text and to text. nlohmann's parser and writer are compiled here, once: each takes seconds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace lippmann {

/// Keys keep their order. A text that is no JSON gives a value of which is_discarded() holds.
nlohmann::ordered_json json_from_text(std::string_view text);

/// On lines indented by so many spaces; below 0: all on one line. Bytes that are no UTF-8 become U+FFFD.
std::string json_to_text(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace lippmann
