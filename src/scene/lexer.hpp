// Splits the text of a scene file into words and numbers, and tracks line numbers.
//
// Words are separated by white space. A word that starts with `#` begins a comment that ends with its line. Keywords are
// case-insensitive.
#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

class Lexer {
 public:
  /// `name` is the file's name in messages.
  Lexer(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}
  Lexer(const Lexer&) = delete;  // not copyable because returned words point into text_
  Lexer& operator=(const Lexer&) = delete;

  bool at_end();

  bool at_line_end();

  std::string_view peek();

  /// Reads the next word. The view is valid as long as the Lexer exists. Throws Error at the end of the file; the message names
  /// `wanted`.
  std::string_view word(std::string_view wanted);

  /// Reads the next word. Throws Error if it is not `keyword`, which must be upper case. The comparison ignores case.
  void expect(std::string_view keyword);

  std::string_view rest_of_line();

  float number(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  int integer(std::string_view wanted, int lowest, int highest);

  Vec3f vector(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// Reads one coordinate of a position (axis 0 to 2) and subtracts the origin's coordinate in double precision.
  float coordinate(int axis, std::string_view wanted, float largest = std::numeric_limits<float>::max());

  Vec3f point(std::string_view wanted, float largest = std::numeric_limits<float>::max());
  void set_origin(const Vec3d& origin) { origin_ = origin; }
  const Vec3d& origin() const { return origin_; }

  // These functions read the given keyword and then a value.
  float number_after(std::string_view keyword);
  Vec3f vector_after(std::string_view keyword);
  Vec3f point_after(std::string_view keyword);

  std::string where() const;
  const std::string& name() const { return name_; }
  int line() const { return word_line_; }

  Error error(std::string problem, std::string accepted = {}) const {
    return {where(), std::move(problem), std::move(accepted)};
  }

 private:
  void skip_blanks();
  std::string_view word_here() const;

  template <class T>
  T number_of_type(std::string_view wanted, float largest);

  std::string name_, text_;
  Vec3d origin_{0.0};
  std::size_t position_ = 0;
  int line_ = 1;
  int word_line_ = 1;
};

bool is_keyword(std::string_view word, std::string_view keyword);

std::string upper(std::string_view word);

}  // namespace lippmann
