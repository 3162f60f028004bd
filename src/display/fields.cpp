#include "display/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::json;

const Json kNone;

}  // namespace

Fields::Fields(const Json& json, std::string where, std::string table)
    : json_(json), where_(std::move(where)), table_(std::move(table)) {
  if (!json.is_object()) throw Error(where_, fmt::format("'{}' is no table", table_), "a table of keys and values");
}

void Fields::reject(std::string_view key, const std::string& problem, const std::string& accepted) const {
  const std::string name = table_.empty() ? std::string(key) : table_ + "." + std::string(key);
  throw Error(fmt::format("{}: {}", where_, printable(name)), problem, accepted);
}

bool Fields::has(std::string_view key) const { return !value(key).is_null(); }

const Json& Fields::value(std::string_view key) const {
  const auto found = json_.find(std::string(key));
  if (found == json_.end()) return kNone;
  if (!found->is_object()) return *found;
  const auto wrapped = found->find("value");
  return wrapped == found->end() ? *found : *wrapped;
}

double Fields::checked(std::string_view key, const Json& json, Range range) const {
  const std::string accepted = fmt::format("a number from {} to {}", range.low, range.high);
  if (json.is_null()) reject(key, "is missing", accepted);
  if (!json.is_number()) reject(key, "is no number", accepted);
  const double number = json.get<double>();
  if (!(number >= range.low && number <= range.high)) reject(key, fmt::format("is {}", number), accepted);
  return number;
}

int Fields::whole_of(std::string_view key, const Json& json, Range range) const {
  const double number = checked(key, json, range);
  if (number != std::floor(number))
    reject(key, fmt::format("is {}", number), fmt::format("a whole number from {} to {}", range.low, range.high));
  return static_cast<int>(number);
}

double Fields::number(std::string_view key, Range range) const { return checked(key, value(key), range); }

double Fields::number_or(std::string_view key, Range range, double otherwise) const {
  return has(key) ? number(key, range) : otherwise;
}

int Fields::whole(std::string_view key, Range range) const { return whole_of(key, value(key), range); }

int Fields::whole_or(std::string_view key, Range range, int otherwise) const {
  return has(key) ? whole(key, range) : otherwise;
}

bool Fields::flag_or(std::string_view key, bool otherwise) const {
  const Json& json = value(key);
  if (json.is_null()) return otherwise;
  if (json.is_boolean()) return json.get<bool>();
  return checked(key, json, {-1e9, 1e9}) != 0.0;
}

std::string Fields::text(std::string_view key) const {
  const Json& json = value(key);
  if (!json.is_string()) reject(key, json.is_null() ? "is missing" : "is no text", "text");
  return json.get<std::string>();
}

std::string Fields::text_or(std::string_view key, std::string otherwise) const { return has(key) ? text(key) : otherwise; }

std::vector<std::string> Fields::texts_or_none(std::string_view key) const {
  std::vector<std::string> texts;
  if (!has(key)) return texts;
  if (!value(key).is_array()) reject(key, "is no list", "a list of texts");
  for (const Json& element : value(key)) {
    if (!element.is_string()) reject(key, "has an element that is no text", "a list of texts");
    texts.push_back(element.get<std::string>());
  }
  return texts;
}

Vec2i Fields::pair(std::string_view key, Range range) const {
  const Json& json = value(key);
  if (!json.is_array() || json.size() != 2)
    reject(key, json.is_null() ? "is missing" : "is no pair", "[across, down], two whole numbers");
  return {whole_of(key, json[0], range), whole_of(key, json[1], range)};
}

std::size_t Fields::word_or(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) const {
  if (!has(key)) return otherwise;
  const std::string word = text(key);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) reject(key, "is " + shown(word), fmt::format("{}", fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

Fields Fields::inner(std::string_view key) const {
  const auto found = json_.find(std::string(key));
  return Fields(found == json_.end() ? kNone : *found, where_, std::string(key));
}

void Fields::allow_only(const std::vector<std::string_view>& keys) const {
  for (const auto& member : json_.items()) {
    if (std::find(keys.begin(), keys.end(), member.key()) != keys.end()) continue;
    reject(member.key(), "there is no such key" + did_you_mean(member.key(), keys), fmt::format("{}", fmt::join(keys, ", ")));
  }
}

}  // namespace lippmann
