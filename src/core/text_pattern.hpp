// Regular expressions in ECMAScript syntax. Only text_pattern.cpp includes <regex>, because it takes seconds to compile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct PatternMatch {
  std::size_t begin = 0, end = 0;
  std::vector<std::string> groups;
};

class TextPattern {
 public:
  enum class Letters { kAsWritten, kEitherCase };

  explicit TextPattern(const std::string& expression, Letters letters = Letters::kAsWritten);

  std::optional<PatternMatch> match(const std::string& text) const;
  std::optional<PatternMatch> search(const std::string& text) const;

 private:
  struct Expression;
  std::shared_ptr<const Expression> expression_;
};

}  // namespace lippmann
