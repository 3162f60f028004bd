#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct NumberRange {
  double low, high;
};

inline constexpr NumberRange kAnyNumber{-1e30, 1e30};
inline constexpr NumberRange kAnyCount{1.0, 1e9};

/// A null member counts as missing, unless stated otherwise.
class JsonFields {
 public:
  using Json = nlohmann::ordered_json;

  /// `json` must outlive this object. `where` is the name of the file for errors; if it is empty, errors name only the key.
  /// `object` is the name of the JSON object for errors; it is empty for the document itself. Throws Error if `json` is not an
  /// object.
  JsonFields(const Json& json, std::string where, std::string object);

  bool has(std::string_view key) const { return !value(key).is_null(); }
  const Json& value(std::string_view key) const;

  /// Throws Error naming all missing members if there are several. Null members count as present. A single missing member is
  /// left to the function that reads it, whose message states the range.
  void require(const std::vector<std::string_view>& keys) const;

  double number(std::string_view key, NumberRange range = kAnyNumber) const;
  double number_or(std::string_view key, NumberRange range, double otherwise) const;
  float float_number(std::string_view key) const { return static_cast<float>(number(key)); }
  float float_or(std::string_view key, float otherwise) const { return has(key) ? float_number(key) : otherwise; }
  /// Returns a number, or infinity for null. The member must exist.
  float float_or_infinity(std::string_view key) const;
  int whole(std::string_view key, NumberRange range) const;
  int whole_or(std::string_view key, NumberRange range, int otherwise) const;
  bool flag_or(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string otherwise) const;
  std::vector<std::string> texts_or_none(std::string_view key) const;
  std::vector<double> numbers(std::string_view key, std::size_t count, NumberRange range = kAnyNumber) const;
  glm::dvec2 pair(std::string_view key, NumberRange range = kAnyNumber) const;
  Vec2i whole_pair(std::string_view key, NumberRange range) const;
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words) const;
  std::size_t word_or(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) const;

  JsonFields inner(std::string_view key) const;
  /// Returns `json`, which is part of the value of `key`, as an object.
  JsonFields element(std::string_view key, const Json& json) const { return {json, where_, std::string(key)}; }
  /// Returns `json`, which is part of the value of `key`, as a list of `count` numbers.
  std::vector<double> numbers_in(std::string_view key, const Json& json, std::size_t count,
                                 NumberRange range = kAnyNumber) const;

  /// Throws Error for a key that is not in the list; the message suggests the most similar key.
  void allow_only(const std::vector<std::string_view>& keys) const;
  /// Throws Error for a key that no member function has read.
  void allow_read() const { allow_only(std::vector<std::string_view>(read_.begin(), read_.end())); }

  [[noreturn]] void reject(std::string_view key, const std::string& problem, const std::string& accepted) const;

 private:
  double checked(std::string_view key, const Json& json, NumberRange range) const;
  int whole_of(std::string_view key, double number, NumberRange range) const;

  const Json& json_;
  std::string where_, object_;
  mutable std::vector<std::string> read_;  ///< keys passed to value(), including keys of missing members
};

/// Returns the value, or null if it is infinite or NaN. float_or_infinity() reads the result.
nlohmann::ordered_json finite_or_null(double value);

}  // namespace lippmann
