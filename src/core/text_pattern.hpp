// Texts that look so: regular expressions as ECMAScript has them. <regex> stays in text_pattern.cpp, for it takes seconds to
// compile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct PatternMatch {
  std::size_t begin = 0, end = 0;   ///< where in the text
  std::vector<std::string> groups;  ///< the first is the whole match; empty where a group took no part in it
};

/// Any number of threads may use one at once.
class TextPattern {
 public:
  enum class Letters { kAsWritten, kEitherCase };

  explicit TextPattern(const std::string& expression, Letters letters = Letters::kAsWritten);

  /// None if the text as a whole does not look so.
  std::optional<PatternMatch> match(const std::string& text) const;
  /// The first place in the text that looks so.
  std::optional<PatternMatch> search(const std::string& text) const;

 private:
  struct Expression;
  std::shared_ptr<const Expression> expression_;
};

}  // namespace lippmann
