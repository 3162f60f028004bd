#include "display/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 16;

Json json_of(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = json_of(value);
    return object;
  }
  if (const auto* array = node.as_array()) {
    Json list = Json::array();
    for (const toml::node& element : *array) list.push_back(json_of(element));
    return list;
  }
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* truth = node.as_boolean()) return truth->get();
  return nullptr;
}

/// Replaces members of the form {"value": x}, which calibrations use, by x.
Json unwrapped(Json json) {
  for (auto& member : json) {
    if (member.is_object() && member.contains("value"))
      member = Json(member["value"]);
    else if (member.is_structured())
      member = unwrapped(std::move(member));
  }
  return json;
}

/// Throws Error if the text is too long or if brackets outside of strings are nested too deep. Call this before parsing.
void check_limits(std::string_view text, const std::string& where, const char* kind) {
  if (text.size() > kMaxDocumentBytes)
    throw Error(where, fmt::format("has {} bytes", text.size()),
                fmt::format("{} of at most {} bytes", kind, kMaxDocumentBytes));
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') ++i;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kMaxDepth) throw Error(where, "is nested too deep", fmt::format("at most {} levels", kMaxDepth));
  }
}

int line_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  return static_cast<int>(1 + std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

Json parse_toml(std::string_view text, const std::string& where) {
  if (text.size() > kMaxDocumentBytes) check_limits(text, where, "TOML");
  try {
    return unwrapped(json_of(toml::parse(text, where)));
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}:{}", where, error.source().begin.line), printable(error.description()), "TOML: key = value");
  }
}

Json parse_json(std::string_view text, const std::string& where) {
  check_limits(text, where, "JSON");
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object()) throw Error(where, "is not a JSON object", "a calibration: {\"pitch\": {\"value\": 52.0}, ...}");
    return unwrapped(std::move(json));
  } catch (const Json::parse_error& error) {
    throw Error(fmt::format("{}:{}", where, line_of(text, error.byte)), "is not valid JSON", "a calibration");
  } catch (const Json::exception&) {
    throw Error(where, "has a number that is too large", "numbers up to 1.8e308");
  }
}

}  // namespace lippmann
