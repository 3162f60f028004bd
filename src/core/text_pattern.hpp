// Regular expressions in ECMAScript syntax. Only text_pattern.cpp includes <regex>, because it takes seconds to compile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct PatternMatch {
  std::size_t begin = 0, end = 0;   ///< the match is bytes [begin, end) of the text
  std::vector<std::string> groups;  ///< group 0 is the whole match; a group that did not participate is empty
};

/// A regular expression. Thread-safe.
class TextPattern {
 public:
  enum class Letters { kAsWritten, kEitherCase };

  explicit TextPattern(const std::string& expression, Letters letters = Letters::kAsWritten);

  /// Returns the match if the whole text matches, otherwise nothing.
  std::optional<PatternMatch> match(const std::string& text) const;
  /// Returns the first match in the text.
  std::optional<PatternMatch> search(const std::string& text) const;

 private:
  struct Expression;
  std::shared_ptr<const Expression> expression_;
};

}  // namespace lippmann
