#include "core/text_pattern.hpp"

#include <regex>

namespace lippmann {
namespace {

PatternMatch match_of(const std::smatch& found) {
  const auto begin = static_cast<std::size_t>(found.position());
  PatternMatch match{begin, begin + static_cast<std::size_t>(found.length()), {}};
  for (const std::ssub_match& group : found) match.groups.push_back(group.str());
  return match;
}

}  // namespace

struct TextPattern::Expression {
  std::regex regex;
};

TextPattern::TextPattern(const std::string& expression, Letters letters)
    : expression_(std::make_shared<Expression>(
          Expression{std::regex(expression, letters == Letters::kEitherCase ? std::regex::ECMAScript | std::regex::icase
                                                                            : std::regex::ECMAScript)})) {}

std::optional<PatternMatch> TextPattern::match(const std::string& text) const {
  std::smatch found;
  if (!std::regex_match(text, found, expression_->regex)) return std::nullopt;
  return match_of(found);
}

std::optional<PatternMatch> TextPattern::search(const std::string& text) const {
  std::smatch found;
  if (!std::regex_search(text, found, expression_->regex)) return std::nullopt;
  return match_of(found);
}

}  // namespace lippmann
