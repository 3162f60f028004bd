// The members of one JSON object, each checked as it is read: every complaint names file, object and key, and what would be
// accepted. What files of foreign origin say is read through this (glTF has a schema, src/scene/gltf/schema.hpp).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// What a number may be, both ends included.
struct NumberRange {
  double low, high;
};

/// Lengths and angles of which the reader knows no narrower range.
inline constexpr NumberRange kAnyNumber{-1e30, 1e30};
inline constexpr NumberRange kAnyCount{1.0, 1e9};

/// A member that is null counts as one that is missing, unless stated otherwise.
class JsonFields {
 public:
  using Json = nlohmann::ordered_json;

  /// `json` stays where it is. `object`: its name for complaints, empty for the document itself. An empty `where`: complaints
  /// name the key alone. Throws Error where `json` is no object.
  JsonFields(const Json& json, std::string where, std::string object);

  bool has(std::string_view key) const { return !value(key).is_null(); }
  /// Null where there is none.
  const Json& value(std::string_view key) const;

  double number(std::string_view key, NumberRange range = kAnyNumber) const;
  double number_or(std::string_view key, NumberRange range, double otherwise) const;
  float float_number(std::string_view key) const { return static_cast<float>(number(key)); }
  float float_or(std::string_view key, float otherwise) const { return has(key) ? float_number(key) : otherwise; }
  /// Null, which must be there, stands for infinity, which JSON does not have.
  float float_or_infinity(std::string_view key) const;
  int whole(std::string_view key, NumberRange range) const;
  int whole_or(std::string_view key, NumberRange range, int otherwise) const;
  /// true, false, or a number that is 0 or not.
  bool flag_or(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string otherwise) const;
  std::vector<std::string> texts_or_none(std::string_view key) const;
  /// A list of `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count, NumberRange range = kAnyNumber) const;
  glm::dvec2 pair(std::string_view key, NumberRange range = kAnyNumber) const;
  Vec2i whole_pair(std::string_view key, NumberRange range) const;
  /// Which of the words it is, by number.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words) const;
  std::size_t word_or(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) const;

  /// An object inside this one.
  JsonFields inner(std::string_view key) const;
  /// `json`, a part of `key`'s value, as an object.
  JsonFields element(std::string_view key, const Json& json) const { return {json, where_, std::string(key)}; }
  /// `json`, a part of `key`'s value, as a list of `count` numbers.
  std::vector<double> numbers_in(std::string_view key, const Json& json, std::size_t count,
                                 NumberRange range = kAnyNumber) const;

  /// Throws Error for a key that is none of these, with the nearest of them.
  void allow_only(const std::vector<std::string_view>& keys) const;
  /// The same for a key that no function above was called with.
  void allow_read() const { allow_only(std::vector<std::string_view>(read_.begin(), read_.end())); }

  [[noreturn]] void reject(std::string_view key, const std::string& problem, const std::string& accepted) const;

 private:
  double checked(std::string_view key, const Json& json, NumberRange range) const;
  int whole_of(std::string_view key, double number, NumberRange range) const;

  const Json& json_;
  std::string where_, object_;
  mutable std::vector<std::string> read_;  ///< keys that were asked for, missing ones among them
};

/// For a reader that knows infinity as number_or_infinity does.
nlohmann::ordered_json finite_or_null(double value);

}  // namespace lippmann
