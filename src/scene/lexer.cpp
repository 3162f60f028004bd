#include "scene/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace lippmann {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

/// Returns whether the text after a number may be ignored: the C suffix f, or an exponent in which the sign precedes the e.
bool is_harmless_rest(std::string_view rest) {
  if (rest == "f" || rest == "F") return true;
  if (rest.size() < 3 || (rest[0] != '+' && rest[0] != '-') || upper(rest[1]) != 'E') return false;
  return rest.find_first_not_of("0123456789", 2) == std::string_view::npos;
}

/// Parses a finite number and ignores a suffix for which is_harmless_rest() is true. Numbers too small for T become zero.
template <class T>
std::optional<T> parse_number(std::string_view word) {
  word = without_plus(word);
  T value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, failure] = std::from_chars(word.data(), end, value);
  if (rest == word.data()) return std::nullopt;
  if (rest != end && !is_harmless_rest({rest, static_cast<std::size_t>(end - rest)})) return std::nullopt;
  if (failure == std::errc{}) return std::isfinite(value) ? std::optional(value) : std::nullopt;
  double wide = 0.0;
  if (std::from_chars(word.data(), rest, wide).ec == std::errc{} && std::abs(wide) < 1.0) return static_cast<T>(wide);
  return std::nullopt;
}

}  // namespace

bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) { return upper(a) == b; });
}

std::string upper(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = upper(c);
  return result;
}

void Lexer::skip_blanks() {
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (c == '#') {
      position_ = std::min(text_.find('\n', position_), text_.size());
      if (position_ == text_.size()) return;
      ++line_;
    } else if (!is_blank(c)) {
      return;
    } else if (c == '\n') {
      ++line_;
    }
  }
}

bool Lexer::at_end() {
  skip_blanks();
  return position_ == text_.size();
}

bool Lexer::at_line_end() { return at_end() || line_ > word_line_; }

std::string_view Lexer::word_here() const {
  std::size_t end = position_;
  while (end < text_.size() && !is_blank(text_[end])) ++end;
  return std::string_view(text_).substr(position_, end - position_);
}

std::string_view Lexer::peek() {
  skip_blanks();
  return word_here();
}

std::string_view Lexer::word(std::string_view wanted) {
  skip_blanks();
  word_line_ = line_;
  if (position_ == text_.size()) throw error(fmt::format("the file ends, expected {}", wanted));
  const std::string_view result = word_here();
  position_ += result.size();
  return result;
}

void Lexer::expect(std::string_view keyword) {
  const std::string_view found = word(keyword);
  if (!is_keyword(found, keyword)) throw error(fmt::format("expected {}, found {}", keyword, shown(found)));
}

std::string_view Lexer::rest_of_line() {
  if (line_ != word_line_) return {};
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  std::string_view rest = std::string_view(text_).substr(position_, end - position_);
  position_ = end;
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

template <class T>
T Lexer::number_of_type(std::string_view wanted, float largest) {
  const std::string_view found = word(wanted);
  const std::optional<T> value = parse_number<T>(found);
  if (!value) throw error(fmt::format("expected a number for {}, found {}", wanted, shown(found)), "a finite decimal number");
  if (std::abs(*value) > static_cast<T>(largest))
    throw error(fmt::format("{} is out of range for {}", *value, wanted), fmt::format("{:g} to {:g}", -largest, largest));
  return *value;
}

float Lexer::number(std::string_view wanted, float largest) { return number_of_type<float>(wanted, largest); }

int Lexer::integer(std::string_view wanted, int lowest, int highest) {
  const std::string_view found = word(wanted), digits = without_plus(found);
  int value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, failure] = std::from_chars(digits.data(), end, value);
  const bool is_read = rest == end && failure == std::errc{};
  if (!is_read || value < lowest || value > highest)
    throw error(is_read ? fmt::format("{} is out of range for {}", value, wanted)
                        : fmt::format("expected a whole number for {}, found {}", wanted, shown(found)),
                fmt::format("a whole number from {} to {}", lowest, highest));
  return value;
}

Vec3f Lexer::vector(std::string_view wanted, float largest) {
  const float x = number(wanted, largest), y = number(wanted, largest), z = number(wanted, largest);
  return {x, y, z};
}

float Lexer::coordinate(int axis, std::string_view wanted, float largest) {
  if (origin_ == Vec3d(0.0)) return number(wanted, largest);  // without an origin, the text is rounded to float directly
  return static_cast<float>(number_of_type<double>(wanted, largest) - origin_[axis]);
}

Vec3f Lexer::point(std::string_view wanted, float largest) {
  const float x = coordinate(0, wanted, largest), y = coordinate(1, wanted, largest), z = coordinate(2, wanted, largest);
  return {x, y, z};
}

float Lexer::number_after(std::string_view keyword) {
  expect(keyword);
  return number(keyword);
}

Vec3f Lexer::vector_after(std::string_view keyword) {
  expect(keyword);
  return vector(keyword);
}

Vec3f Lexer::point_after(std::string_view keyword) {
  expect(keyword);
  return point(keyword);
}

std::string Lexer::where() const { return fmt::format("{}:{}", name_, word_line_); }

}  // namespace lippmann
