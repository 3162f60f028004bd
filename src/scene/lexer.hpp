// Splits the text of a scene file into words and numbers and tracks line numbers.
//
// Words are separated by white space. A word that starts with `#` begins a comment up to the end of its line. Keywords are
// case-insensitive; names of textures and files are case-sensitive.
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
  /// `name` names the file in messages.
  Lexer(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}
  Lexer(const Lexer&) = delete;  // tokens point into the text
  Lexer& operator=(const Lexer&) = delete;

  /// Returns whether only white space and comments are left.
  bool at_end();

  /// Returns whether no further word follows on the line of the last word.
  bool at_line_end();

  /// Returns the next word without consuming it; empty at the end.
  std::string_view peek();

  /// Reads the next word. The view is valid as long as the Lexer. Throws Error naming `wanted` at the end of the file.
  std::string_view word(std::string_view wanted);

  /// Reads the next word, which must be `keyword` (given in upper case), in any case.
  void expect(std::string_view keyword);

  /// Reads the rest of the last word's line, including comments, without surrounding blanks.
  std::string_view rest_of_line();

  /// Reads a finite number from -largest to largest.
  float number(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// Reads a whole number from `lowest` to `highest`.
  int integer(std::string_view wanted, int lowest, int highest);

  /// Reads three numbers.
  Vec3f vector(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// Reads one coordinate of a position (axis 0 to 2) and subtracts the origin in double precision.
  float coordinate(int axis, std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// Reads a position: three coordinates.
  Vec3f point(std::string_view wanted, float largest = std::numeric_limits<float>::max());
  void set_origin(const Vec3d& origin) { origin_ = origin; }
  const Vec3d& origin() const { return origin_; }

  // Read `keyword` and then a value.
  float number_after(std::string_view keyword);
  Vec3f vector_after(std::string_view keyword);
  Vec3f point_after(std::string_view keyword);

  /// Returns "file:line" of the last word read.
  std::string where() const;
  const std::string& name() const { return name_; }
  int line() const { return word_line_; }

  /// Returns an Error at the last word read.
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
  int line_ = 1;       ///< line of position_
  int word_line_ = 1;  ///< line of the last word read
};

/// Returns whether `word` is `keyword` (given in upper case), in any case.
bool is_keyword(std::string_view word, std::string_view keyword);

/// Converts ASCII letters to upper case.
std::string upper(std::string_view word);

}  // namespace lippmann
