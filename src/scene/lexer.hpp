// Splits the text of a scene file into words and numbers, and says in which line they stood.
//
// Words are separated by white space. A word that starts with `#` begins a comment that runs to the end of its line. Keywords
// are compared without regard to case; names of textures and files are taken as they are.
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
  /// name: what errors call the file.
  Lexer(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}
  Lexer(const Lexer&) = delete;  // tokens point into the text
  Lexer& operator=(const Lexer&) = delete;

  /// Whether only white space and comments are left.
  bool at_end();

  /// Whether no word follows on the line of the word that was read last.
  bool at_line_end();

  /// The next word, which is left to be read; empty at the end.
  std::string_view peek();

  /// The next word. Throws Error that names `wanted` where the file ends instead. Valid as long as the Lexer.
  std::string_view word(std::string_view wanted);

  /// The next word, which must be `keyword` (upper case) in any case.
  void expect(std::string_view keyword);

  /// What is left of the line of the last word, comments too, without blanks around it; empty: nothing.
  std::string_view rest_of_line();

  /// The next word, which must be a finite number from -largest to largest.
  float number(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// The next word, which must be a whole number from `lowest` to `highest`.
  int integer(std::string_view wanted, int lowest, int highest);

  /// Three such numbers.
  Vec3f vector(std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// One coordinate of a position (axis 0 to 2): such a number, from which the origin is subtracted in double precision.
  float coordinate(int axis, std::string_view wanted, float largest = std::numeric_limits<float>::max());

  /// A position: three such coordinates.
  Vec3f point(std::string_view wanted, float largest = std::numeric_limits<float>::max());
  void set_origin(const Vec3d& origin) { origin_ = origin; }
  const Vec3d& origin() const { return origin_; }

  // `expect` followed by a value.
  float number_after(std::string_view keyword);
  Vec3f vector_after(std::string_view keyword);
  Vec3f point_after(std::string_view keyword);

  /// "file:line" of the word that was read last.
  std::string where() const;
  const std::string& name() const { return name_; }
  int line() const { return word_line_; }

  /// An error at the word that was read last.
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
  int line_ = 1;       ///< the line that position_ is in
  int word_line_ = 1;  ///< the line of the word that was read last
};

/// Whether `word` is `keyword` (upper case) in any case.
bool is_keyword(std::string_view word, std::string_view keyword);

/// ASCII letters in upper case.
std::string upper(std::string_view word);

}  // namespace lippmann
