#include "core/json_text.hpp"

#include <nlohmann/json.hpp>

namespace lippmann {

nlohmann::ordered_json json_from_text(std::string_view text) { return nlohmann::ordered_json::parse(text, nullptr, false); }

std::string json_to_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace lippmann
