// The members of one table of a display's file, each checked as it is read; every complaint names file, table and key, and what
// would be accepted. Private to this part.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct Range {
  double low, high;
};

class Fields {
 public:
  /// `table`: its name, empty for the document itself. Throws Error where `json` is no table.
  Fields(const nlohmann::json& json, std::string where, std::string table);

  bool has(std::string_view key) const;
  /// Null where there is none. Numbers may come as {"value": x}, as calibrations have them.
  const nlohmann::json& value(std::string_view key) const;

  double number(std::string_view key, Range range) const;
  double number_or(std::string_view key, Range range, double otherwise) const;
  int whole(std::string_view key, Range range) const;
  int whole_or(std::string_view key, Range range, int otherwise) const;
  /// true, false, or a number that is 0 or not.
  bool flag_or(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string otherwise) const;
  std::vector<std::string> texts_or_none(std::string_view key) const;
  /// [across, down], whole.
  Vec2i pair(std::string_view key, Range range) const;
  /// Which of the words it is, by number.
  std::size_t word_or(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) const;

  /// A table inside this one.
  Fields inner(std::string_view key) const;

  /// A table in a list inside this one.
  Fields element(std::string_view key, const nlohmann::json& json) const { return Fields(json, where_, std::string(key)); }

  /// Throws Error for a key that is none of these, with the nearest of them.
  void allow_only(const std::vector<std::string_view>& keys) const;

  [[noreturn]] void reject(std::string_view key, const std::string& problem, const std::string& accepted) const;

 private:
  double checked(std::string_view key, const nlohmann::json& json, Range range) const;
  int whole_of(std::string_view key, const nlohmann::json& json, Range range) const;

  const nlohmann::json& json_;
  std::string where_, table_;
};

}  // namespace lippmann
