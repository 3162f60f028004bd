#include "scene/gltf/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/gltf/schema_table.hpp"

namespace lippmann::gltf {
namespace {

using Json = nlohmann::json;
using namespace schema;

/// The path from the root to the current value, as a linked list on the call stack.
struct Path {
  const Path* parent = nullptr;
  std::string_view name{};
  std::ptrdiff_t index = -1;

  std::string text() const {
    std::string result = parent ? parent->text() : std::string();
    if (index >= 0) return fmt::format("{}[{}]", result, index);
    if (!result.empty()) result += '.';
    return result + printable(name);
  }
};

class Checker {
 public:
  Checker(const Json& root, const Report& report) : root_(root), report_(report) {}

  SchemaFindings findings;

  void check_object(Json& value, std::span<const Property> properties, const Path& path) {
    if (!value.is_object()) fail(path, "is not an object");
    for (const Property& property : properties)
      if (property.need == kRequired && !value.contains(property.name)) fail({&path, property.name}, "is missing");
    collect_extensions(value, path);
    for (auto it = value.begin(); it != value.end();) {
      const Property* property = find(properties, it.key());
      if (!property) note_unknown(it.key(), path);
      if (!property || has_other_kind(it.value(), *property)) {
        it = value.erase(it);
        continue;
      }
      check(it.value(), *property, {&path, it.key()});
      ++it;
    }
  }

 private:
  static const Property* find(std::span<const Property> properties, std::string_view name) {
    for (const Property& property : properties)
      if (property.name == name) return &property;
    return nullptr;
  }

  static bool has_other_kind(const Json& value, const Property& property) {
    if (property.need != kIfKindMatches) return false;
    if (property.kind == Kind::kObject) return !value.is_object();
    return !value.is_number() && !(property.kind == Kind::kFlag && value.is_boolean());
  }

  [[noreturn]] void fail(const Path& path, const std::string& problem, const std::string& accepted = {}) const {
    report_.fail(path.text(), problem, accepted);
  }

  void collect_extensions(const Json& value, const Path& path) {
    const auto found = value.find("extensions");
    if (found == value.end()) return;
    if (!found->is_object()) fail({&path, "extensions"}, "is not an object");
    for (const auto& entry : found->items()) note_use(entry.key(), value, path);
  }

  /// Records a property that glTF does not define, outside extras and extensions.
  void note_unknown(const std::string& name, const Path& path) {
    constexpr std::string_view kUnused[] = {"name",
                                            "extras",
                                            "extensions",
                                            "copyright",
                                            "generator",
                                            "min",
                                            "max",
                                            "target",
                                            "mimeType",
                                            "skeleton",
                                            "irradianceCoefficients",
                                            "specularImageSize"};
    if (path.name == "extras" || path.name == "extensions") return;
    if (std::find(std::begin(kUnused), std::end(kUnused), name) != std::end(kUnused)) return;
    findings.unknown.add(name, findings.unknown.empty() ? report_.where(path.text()) : std::string());
  }

  void note_use(const std::string& extension, const Json& user, const Path& path) {
    ExtensionUse& use = findings.extensions[extension];
    if (++use.count > ExtensionUse::kMostNamed) return;
    const auto name = user.find("name");
    use.users.push_back({path.text(), name != user.end() && name->is_string() ? name->get<std::string>() : ""});
  }

  void check(Json& value, const Property& property, const Path& path) {
    switch (property.kind) {
      case Kind::kBool:
        if (!value.is_boolean()) fail(path, "is not true or false");
        return;
      case Kind::kFlag:
        return;
      case Kind::kString:
        return check_string(value, property, path);
      case Kind::kNumber:
        return check_number(value, property, path);
      case Kind::kInteger:
        return check_integer(value, property, path);
      case Kind::kIndex:
        return check_index(value, property, path);
      case Kind::kIndexMap:
        return check_index_map(value, property, path);
      case Kind::kIntegerMap:
        return check_integer_map(value, property, path);
      case Kind::kObject:
        return check_object(value, property.object, path);
      case Kind::kStrings:
        return for_each(value, path, [&](Json& entry, const Path& at) { check_string(entry, property, at); });
      case Kind::kNumbers:
        for_each(value, path, [&](Json& entry, const Path& at) { check_number(entry, property, at); });
        if (property.length && value.size() != property.length)
          fail(path, fmt::format("has {} entries", value.size()), fmt::format("{}", property.length));
        return;
      case Kind::kIndices:
        for_each(value, path, [&](Json& entry, const Path& at) { check_index(entry, property, at); });
        return check_distinct(value, path);
      case Kind::kIndexLists:
        return for_each(value, path, [&](Json& entry, const Path& at) { check_index_list(entry, property, at); });
      case Kind::kIndexMaps:
        return for_each(value, path, [&](Json& entry, const Path& at) { check_index_map(entry, property, at); });
      case Kind::kObjects:
        return for_each(value, path, [&](Json& entry, const Path& at) { check_object(entry, property.object, at); });
    }
  }

  template <class F>
  void for_each(Json& value, const Path& path, const F& check_entry) const {
    if (!value.is_array()) fail(path, "is not an array");
    for (std::size_t i = 0; i < value.size(); ++i) check_entry(value[i], Path{&path, {}, static_cast<std::ptrdiff_t>(i)});
  }

  void check_string(const Json& value, const Property& property, const Path& path) const {
    if (!value.is_string()) fail(path, "is not a string");
    const std::string& text = value.get_ref<const std::string&>();
    if (property.choices.empty()) return;
    if (text.find('|') == std::string::npos && property.choices.find('|' + text + '|') != std::string_view::npos) return;
    std::string accepted;
    for (const char c : property.choices.substr(1, property.choices.size() - 2))
      accepted += c == '|' ? ", " : std::string(1, c);
    fail(path, "is " + shown(text), accepted);
  }

  void check_number(const Json& value, const Property& property, const Path& path) const {
    if (!value.is_number()) fail(path, "is not a number");
    require_range(value.get<double>(), property.lower, property.upper, path);
  }

  void require_range(double x, double lower, double upper, const Path& path) const {
    if (x >= lower && x <= upper) return;
    const bool open = upper >= FLT_MAX;
    fail(path, fmt::format("is {}", x), open ? fmt::format("{} or more", lower) : fmt::format("{} to {}", lower, upper));
  }

  /// Numbers such as 3.0 are accepted and converted to integers.
  void check_integer(Json& value, const Property& property, const Path& path) const {
    if (!value.is_number()) fail(path, "is not an integer");
    const double x = value.get<double>();
    if (x != std::floor(x)) fail(path, fmt::format("is {}, not an integer", x));
    require_range(x, property.lower, property.upper, path);
    if (std::fmod(x, property.multiple_of) != 0.0)
      fail(path, fmt::format("is {}", x), fmt::format("multiples of {}", property.multiple_of));
    if (value.is_number_float()) value = static_cast<std::uint64_t>(x);
  }

  std::size_t count_of(std::string_view array) const {
    if (array.starts_with('/')) {
      const Json::json_pointer pointer{std::string(array)};
      return root_.contains(pointer) && root_.at(pointer).is_array() ? root_.at(pointer).size() : 0;
    }
    const auto found = root_.find(array);
    return found != root_.end() && found->is_array() ? found->size() : 0;
  }

  void check_index(Json& value, const Property& property, const Path& path) const {
    check_integer(value, property, path);
    const std::size_t count = count_of(property.refers_to), i = value.get<std::size_t>();
    const std::string_view name = property.refers_to.substr(property.refers_to.rfind('/') + 1);
    if (i >= count) fail(path, fmt::format("refers to {0}[{1}], but the number of {0} is {2}", name, i, count));
  }

  void check_index_list(Json& value, const Property& property, const Path& path) const {
    for_each(value, path, [&](Json& entry, const Path& at) { check_index(entry, property, at); });
    if (value.size() != property.length)
      fail(path, fmt::format("has {} entries", value.size()), fmt::format("{}", property.length));
  }

  void check_index_map(Json& value, const Property& property, const Path& path) const {
    if (!value.is_object()) fail(path, "is not an object");
    for (auto it = value.begin(); it != value.end(); ++it) check_index(it.value(), property, {&path, it.key()});
  }

  void check_integer_map(Json& value, const Property& property, const Path& path) const {
    if (!value.is_object()) fail(path, "is not an object");
    for (auto it = value.begin(); it != value.end(); ++it) check_integer(it.value(), property, {&path, it.key()});
  }

  void check_distinct(const Json& value, const Path& path) const {
    std::set<std::size_t> seen;
    for (const Json& entry : value)
      if (!seen.insert(entry.get<std::size_t>()).second) fail(path, fmt::format("lists {} twice", entry.get<std::size_t>()));
  }

  const Json& root_;
  const Report& report_;
};

}  // namespace

SchemaFindings check_schema(Json& root, const Report& report) {
  Checker checker(root, report);
  checker.check_object(root, kRoot, {});
  return std::move(checker.findings);
}

}  // namespace lippmann::gltf
