#include "scene/gltf/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "core/file_content.hpp"

namespace lippmann::gltf {
namespace {

using Json = nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'), before.size() - line_start + 1);
}

/// Reads through a document once, without keeping anything, and stops at the first thing that is wrong. (The library's own
/// callback parser could check limits while it builds, but takes time quadratic in the length of an array.)
class LimitCheck : public Json::json_sax_t {
 public:
  LimitCheck(std::string_view text, const GltfLimits& limits, const Report& report)
      : text_(text), limits_(limits), report_(report) {}

  bool null() override { return count_value(); }
  bool boolean(bool) override { return count_value(); }
  bool number_integer(number_integer_t) override { return count_value(); }
  bool number_unsigned(number_unsigned_t) override { return count_value(); }
  bool number_float(number_float_t, const string_t&) override { return count_value(); }
  bool string(string_t&) override { return count_value(); }
  bool binary(binary_t&) override { return count_value(); }
  bool key(string_t& name) override {
    key_ = name;
    return count_value();
  }

  bool start_object(std::size_t) override {
    if (++objects_ > limits_.json_objects)
      report_.fail("", "the JSON has too many objects", fmt::format("at most {}", limits_.json_objects));
    return enter();
  }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }

  bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override {
    if (dynamic_cast<const Json::out_of_range*>(&error))
      report_.fail("", fmt::format("the JSON has a number that is too large: {} of {} ({})", shown(token), shown(key_),
                                   line_and_column(text_, position - token.size())));
    const std::size_t at = position > 0 ? position - 1 : 0;
    if (text_.find_first_not_of(" \t\r\n") >= at)
      report_.fail("", fmt::format("is {}, neither a .glb nor JSON", describe_content(std::as_bytes(std::span(text_))).what));
    report_.fail("", "is neither a .glb nor valid JSON: " + line_and_column(text_, at));
  }

 private:
  bool count_value() {
    if (++values_ > limits_.json_values)
      report_.fail("", "the JSON has too many values", fmt::format("at most {}", limits_.json_values));
    return true;
  }
  bool enter() {
    if (++depth_ > limits_.json_depth)
      report_.fail("", "the JSON is nested too deep", fmt::format("at most {} levels", limits_.json_depth));
    return count_value();
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::string_view text_;
  const GltfLimits& limits_;
  const Report& report_;
  std::uint64_t values_ = 0, objects_ = 0;
  std::string key_;  ///< the latest
  int depth_ = 0;
};

}  // namespace

Json parse_json(std::string_view text, const GltfLimits& limits, const Report& report) {
  LimitCheck check(text, limits, report);
  Json::sax_parse(text.begin(), text.end(), &check);
  Json root = Json::parse(text.begin(), text.end());
  if (!root.is_object()) report.fail("", "the JSON is not an object");
  return root;
}

}  // namespace lippmann::gltf
