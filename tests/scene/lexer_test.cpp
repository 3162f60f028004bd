#include "scene/lexer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace lippmann {
namespace {

using ::testing::HasSubstr;

TEST(Lexer, words_are_separated_by_any_white_space) {
  Lexer lexer("a", " one\ttwo\r\nthree\v\ffour ");
  for (const char* expected : {"one", "two", "three", "four"}) EXPECT_EQ(lexer.word("x"), expected);
  EXPECT_TRUE(lexer.at_end());
}

TEST(Lexer, peek_keeps_word_and_line) {
  Lexer lexer("a", "A\nB");
  EXPECT_EQ(lexer.word("x"), "A");
  EXPECT_EQ(lexer.peek(), "B");
  EXPECT_EQ(lexer.where(), "a:1");
  EXPECT_EQ(lexer.word("x"), "B");
  EXPECT_EQ(lexer.peek(), "");
}

TEST(Lexer, line_ends_before_blanks_and_comments) {
  Lexer lexer("a", "A B # comment\nC");
  lexer.word("x");
  EXPECT_FALSE(lexer.at_line_end());
  lexer.word("x");
  EXPECT_TRUE(lexer.at_line_end());
  lexer.word("x");
  EXPECT_TRUE(lexer.at_line_end());
}

TEST(Lexer, comment_ends_at_the_line) {
  Lexer lexer("a", "# all of this\nA #not this\nB#3 # end");
  EXPECT_EQ(lexer.word("x"), "A");
  EXPECT_EQ(lexer.word("x"), "B#3");  // # within a word does not begin a comment
  EXPECT_TRUE(lexer.at_end());
}

TEST(Lexer, where_names_the_last_word_s_line) {
  Lexer lexer("a.dat", "A\n\n# comment\nB\nC");
  lexer.word("x");
  EXPECT_EQ(lexer.where(), "a.dat:1");
  lexer.word("x");
  EXPECT_EQ(lexer.where(), "a.dat:4");
}

TEST(Lexer, expect_takes_any_case) {
  Lexer lexer("a", "Center CENTER center");
  for (int i = 0; i < 3; ++i) EXPECT_NO_THROW(lexer.expect("CENTER"));
}

TEST(Lexer, expect_of_another_word_names_both) {
  Lexer lexer("a.dat", "\nCENTRE");
  try {
    lexer.expect("CENTER");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.dat:2: expected CENTER, found 'CENTRE'");
  }
}

TEST(Lexer, end_of_file_names_what_was_wanted) {
  Lexer lexer("a.dat", "A\n\n");
  lexer.word("x");
  try {
    lexer.word("RAD");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.dat:3: the file ends, expected RAD");
  }
}

struct NumberCase {
  const char* text;
  float value;
};

void PrintTo(const NumberCase& number, std::ostream* out) { *out << number.text; }

class TachyonLexerNumber : public testing::TestWithParam<NumberCase> {};

TEST_P(TachyonLexerNumber, text_gives_value) {
  Lexer lexer("a", GetParam().text);
  EXPECT_EQ(lexer.number("x"), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(Forms, TachyonLexerNumber,
                         testing::Values(NumberCase{"1", 1.0f}, NumberCase{"-0.5", -0.5f}, NumberCase{"+2.5", 2.5f},
                                         NumberCase{"0.", 0.0f}, NumberCase{".25", 0.25f}, NumberCase{"1e3", 1000.0f},
                                         NumberCase{"-1.5E-2", -0.015f}, NumberCase{"1.11022e-16", 1.11022e-16f},
                                         NumberCase{"1e-60", 0.0f}, NumberCase{"-1e-60", 0.0f}, NumberCase{"3.4e38", 3.4e38f},
                                         NumberCase{"0.5f", 0.5f}, NumberCase{"3.1+e2", 3.1f}, NumberCase{"-3.1-E2", -3.1f}));

class TachyonLexerBadNumber : public testing::TestWithParam<const char*> {};

TEST_P(TachyonLexerBadNumber, text_is_an_error_that_shows_it) {
  Lexer lexer("a.dat", GetParam());
  try {
    lexer.number("RAD");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.dat:1: expected a number for RAD, found '"));
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, TachyonLexerBadNumber,
                         testing::Values("nan", "NaN", "inf", "-inf", "infinity", "1e39", "-1e39", "1e999", "1e9999999999",
                                         "1,5", "1.0,", "0x10", "--1", "+-1", "+", "-", ".", "one", "1e", "1+e", "1+2", "nanf",
                                         "f", "1.2.3", "1_0"));

TEST(Lexer, integer_takes_whole_numbers_within_its_range) {
  Lexer lexer("a", "0 +7 -3");
  EXPECT_EQ(lexer.integer("x", 0, 9), 0);
  EXPECT_EQ(lexer.integer("x", 0, 9), 7);
  EXPECT_EQ(lexer.integer("x", -5, 9), -3);
}

TEST(Lexer, integer_rejects_fractions_and_range) {
  for (const char* text : {"1.5", "10", "-1", "99999999999", "x", "1e1"}) {
    Lexer lexer("a", text);
    EXPECT_THROW(lexer.integer("x", 0, 9), Error) << text;
  }
}

TEST(Lexer, shown_word_is_shortened_and_printable) {
  EXPECT_EQ(shown("a\x01\xff"
                  "b"),
            "'a??b'");
  EXPECT_EQ(shown(std::string(100, 'x')).size(), 60 + std::strlen("'...'"));
}

}  // namespace
}  // namespace lippmann
