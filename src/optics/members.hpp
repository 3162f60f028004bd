// The members of one JSON object, read with complaints that name the file and the key.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

/// The members of one JSON object; every complaint names the file and the key.
class Members {
 public:
  Members(const nlohmann::ordered_json& json, const std::string& where) : json_(json), where_(where) {
    if (!json.is_object()) throw Error(where, "\"optics\" is not an object");
  }

  [[noreturn]] void reject(std::string_view key, const std::string& problem, const std::string& accepted) const {
    throw Error(where_, "\"" + std::string(key) + "\" of \"optics\" " + problem, accepted);
  }

  const nlohmann::ordered_json& value(std::string_view key) const {
    const auto found = json_.find(std::string(key));
    if (found == json_.end()) reject(key, "is missing", "the report.json that the render wrote");
    return *found;
  }

  bool has(std::string_view key) const { return json_.contains(std::string(key)); }

  double exact(std::string_view key, const nlohmann::ordered_json& json) const {
    if (!json.is_number()) reject(key, "is not a number", "a number");
    const double value = json.get<double>();
    if (!(std::abs(value) <= 1e30)) reject(key, "is no length or angle", "a number within 1e30");
    return value;
  }
  double exact(std::string_view key) const { return exact(key, value(key)); }

  float number(std::string_view key, const nlohmann::ordered_json& json) const { return static_cast<float>(exact(key, json)); }

  float number(std::string_view key) const { return number(key, value(key)); }
  float number_or(std::string_view key, float otherwise) const { return has(key) ? number(key) : otherwise; }

  float number_or_infinity(std::string_view key) const { return value(key).is_null() ? kInfinity : number(key); }

  int count(std::string_view key) const {
    const nlohmann::ordered_json& json = value(key);
    if (!json.is_number_integer()) reject(key, "is not a whole number", "a whole number");
    const double exact = json.get<double>();
    if (!(exact >= 1.0 && exact <= 1e9)) reject(key, "is no count", "a whole number above 0");
    return json.get<int>();
  }

  bool flag_or(std::string_view key, bool otherwise) const {
    if (!has(key)) return otherwise;
    if (!value(key).is_boolean()) reject(key, "is neither true nor false", "true or false");
    return value(key).get<bool>();
  }

  std::string word(std::string_view key) const {
    if (!value(key).is_string()) reject(key, "is not text", "text");
    return value(key).get<std::string>();
  }

  Vec2f pair_or(std::string_view key, Vec2f otherwise) const { return has(key) ? pair(key, value(key)) : otherwise; }

  Vec2f pair(std::string_view key, const nlohmann::ordered_json& json) const {
    if (!json.is_array() || json.size() != 2) reject(key, "is not a pair", "two numbers [x, y]");
    return {number(key, json[0]), number(key, json[1])};
  }

 private:
  const nlohmann::ordered_json& json_;
  const std::string& where_;
};

/// JSON has no infinity: null says it.
inline nlohmann::ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace lippmann
