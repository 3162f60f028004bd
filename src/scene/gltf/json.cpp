#include "scene/gltf/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lippmann::gltf {
namespace {

using Json = nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'), before.size() - line_start + 1);
}

}  // namespace

Json parse_json(std::string_view text, const GltfLimits& limits, const Report& report) {
  std::uint64_t values = 0, objects = 0;
  const auto within_limits = [&](int depth, Json::parse_event_t event, const Json&) {
    if (depth >= limits.json_depth)
      report.fail("", "the JSON is nested too deep", fmt::format("at most {} levels", limits.json_depth));
    if (event == Json::parse_event_t::object_start && ++objects > limits.json_objects)
      report.fail("", "the JSON has too many objects", fmt::format("at most {}", limits.json_objects));
    if (event != Json::parse_event_t::object_end && event != Json::parse_event_t::array_end && ++values > limits.json_values)
      report.fail("", "the JSON has too many values", fmt::format("at most {}", limits.json_values));
    return true;
  };
  try {
    Json root = Json::parse(text.begin(), text.end(), within_limits);
    if (!root.is_object()) report.fail("", "the JSON is not an object");
    return root;
  } catch (const Json::parse_error& error) {
    // byte counts from 1 and is 0 where the text ended too early for a position.
    const std::size_t offset = error.byte > 0 ? error.byte - 1 : text.size();
    report.fail("", "is neither a .glb nor valid JSON: " + line_and_column(text, offset));
  } catch (const Json::exception&) {
    report.fail("", "the JSON has a number that is too large");
  }
}

}  // namespace lippmann::gltf
