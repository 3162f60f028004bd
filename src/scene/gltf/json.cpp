#include "scene/gltf/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/file_content.hpp"

namespace lippmann::gltf {
namespace {

using Json = nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'), before.size() - line_start + 1);
}

/// Builds the document while the text is parsed, and stops at the first exceeded limit. The library's simpler callback
/// interface takes quadratic time in the length of an array.
class LimitedBuilder : public Json::json_sax_t {
 public:
  LimitedBuilder(std::string_view text, const GltfLimits& limits, const Report& report)
      : text_(text), limits_(limits), report_(report) {}

  Json root;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& name) override {
    count_value();
    key_ = name;
    return true;
  }

  bool start_object(std::size_t) override {
    if (++objects_ > limits_.json_objects)
      report_.fail("", "the JSON has too many objects", fmt::format("at most {}", limits_.json_objects));
    return enter(Json::object());
  }
  bool start_array(std::size_t) override { return enter(Json::array()); }
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
  void count_value() {
    if (++values_ > limits_.json_values)
      report_.fail("", "the JSON has too many values", fmt::format("at most {}", limits_.json_values));
  }
  bool add(Json value) {
    place(std::move(value));
    return true;
  }
  Json& place(Json value) {
    count_value();
    if (open_.empty()) return root = std::move(value);
    if (open_.back()->is_array()) return open_.back()->emplace_back(std::move(value));
    return (*open_.back())[key_] = std::move(value);
  }
  bool enter(Json container) {
    if (open_.size() == static_cast<std::size_t>(limits_.json_depth))
      report_.fail("", "the JSON is nested too deeply", fmt::format("at most {} levels", limits_.json_depth));
    open_.push_back(&place(std::move(container)));
    return true;
  }
  bool leave() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const GltfLimits& limits_;
  const Report& report_;
  std::uint64_t values_ = 0, objects_ = 0;
  std::string key_;
  /// The open arrays and objects, outermost first. Their addresses do not change until they are closed.
  std::vector<Json*> open_;
};

}  // namespace

Json parse_json(std::string_view text, const GltfLimits& limits, const Report& report) {
  LimitedBuilder builder(text, limits, report);
  Json::sax_parse(text.begin(), text.end(), &builder);
  if (!builder.root.is_object()) report.fail("", "the JSON is not an object");
  return std::move(builder.root);
}

}  // namespace lippmann::gltf
