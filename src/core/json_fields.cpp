#include "core/json_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

const Json kNone;

}  // namespace

JsonFields::JsonFields(const Json& json, std::string where, std::string object)
    : json_(json), where_(std::move(where)), object_(std::move(object)) {
  if (!json.is_object())
    throw Error(where_, fmt::format("{} is not an object", object_.empty() ? "it" : shown(object_)), "keys and values");
}

void JsonFields::reject(std::string_view key, const std::string& problem, const std::string& accepted) const {
  const std::string name = object_.empty() ? std::string(key) : object_ + "." + std::string(key);
  throw Error(where_.empty() ? printable(name) : fmt::format("{}: {}", where_, printable(name)), problem, accepted);
}

const Json& JsonFields::value(std::string_view key) const {
  const std::string& name = read_.emplace_back(key);
  const auto found = json_.find(name);
  return found == json_.end() ? kNone : *found;
}

void JsonFields::require(const std::vector<std::string_view>& keys) const {
  std::vector<std::string_view> missing;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(missing),
               [&](std::string_view key) { return !json_.contains(std::string(key)); });
  if (missing.size() > 1)
    reject(fmt::format("{}", fmt::join(missing, ", ")), "are missing", fmt::format("all of {}", fmt::join(keys, ", ")));
}

double JsonFields::checked(std::string_view key, const Json& json, NumberRange range) const {
  const std::string accepted = fmt::format("a number from {} to {}", range.low, range.high);
  if (json.is_null()) reject(key, "is missing", accepted);
  if (!json.is_number()) reject(key, "is not a number", accepted);
  const double number = json.get<double>();
  if (!(number >= range.low && number <= range.high)) reject(key, fmt::format("is {}", number), accepted);
  return number;
}

int JsonFields::whole_of(std::string_view key, double number, NumberRange range) const {
  if (number != std::floor(number))
    reject(key, fmt::format("is {}", number), fmt::format("a whole number from {} to {}", range.low, range.high));
  return static_cast<int>(number);
}

double JsonFields::number(std::string_view key, NumberRange range) const { return checked(key, value(key), range); }

double JsonFields::number_or(std::string_view key, NumberRange range, double otherwise) const {
  return has(key) ? number(key, range) : otherwise;
}

float JsonFields::float_or_infinity(std::string_view key) const {
  return json_.contains(std::string(key)) && !has(key) ? kInfinity : float_number(key);
}

int JsonFields::whole(std::string_view key, NumberRange range) const { return whole_of(key, number(key, range), range); }

int JsonFields::whole_or(std::string_view key, NumberRange range, int otherwise) const {
  return has(key) ? whole(key, range) : otherwise;
}

bool JsonFields::flag_or(std::string_view key, bool otherwise) const {
  const Json& json = value(key);
  if (json.is_null()) return otherwise;
  if (json.is_boolean()) return json.get<bool>();
  return checked(key, json, {-1e9, 1e9}) != 0.0;
}

std::string JsonFields::text(std::string_view key) const {
  const Json& json = value(key);
  if (!json.is_string()) reject(key, json.is_null() ? "is missing" : "is not a text", "text");
  return json.get<std::string>();
}

std::string JsonFields::text_or(std::string_view key, std::string otherwise) const { return has(key) ? text(key) : otherwise; }

std::vector<std::string> JsonFields::texts_or_none(std::string_view key) const {
  std::vector<std::string> texts;
  if (!has(key)) return texts;
  if (!value(key).is_array()) reject(key, "is not a list", "a list of texts");
  for (const Json& element : value(key)) {
    if (!element.is_string()) reject(key, "has an element that is not a text", "a list of texts");
    texts.push_back(element.get<std::string>());
  }
  return texts;
}

std::vector<double> JsonFields::numbers(std::string_view key, std::size_t count, NumberRange range) const {
  return numbers_in(key, value(key), count, range);
}

std::vector<double> JsonFields::numbers_in(std::string_view key, const Json& json, std::size_t count, NumberRange range) const {
  if (!json.is_array() || json.size() != count)
    reject(key, json.is_null() ? "is missing" : "is not a list, or has another length",
           fmt::format("a list of {} numbers", count));
  std::vector<double> numbers;
  for (const Json& number : json) numbers.push_back(checked(key, number, range));
  return numbers;
}

glm::dvec2 JsonFields::pair(std::string_view key, NumberRange range) const {
  const std::vector<double> both = numbers(key, 2, range);
  return {both[0], both[1]};
}

Vec2i JsonFields::whole_pair(std::string_view key, NumberRange range) const {
  const glm::dvec2 both = pair(key, range);
  return {whole_of(key, both.x, range), whole_of(key, both.y, range)};
}

std::size_t JsonFields::word(std::string_view key, const std::vector<std::string_view>& words) const {
  const std::string word = text(key);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) reject(key, "is " + shown(word), fmt::format("one of {}", fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

std::size_t JsonFields::word_or(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) const {
  return has(key) ? word(key, words) : otherwise;
}

JsonFields JsonFields::inner(std::string_view key) const { return element(key, value(key)); }

void JsonFields::allow_only(const std::vector<std::string_view>& keys) const {
  for (const auto& member : json_.items()) {
    if (std::find(keys.begin(), keys.end(), member.key()) != keys.end()) continue;
    reject(member.key(), "there is no such key" + did_you_mean(member.key(), keys),
           keys.empty() ? "nothing" : fmt::format("{}", fmt::join(keys, ", ")));
  }
}

nlohmann::ordered_json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace lippmann
