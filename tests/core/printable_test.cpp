#include "core/printable.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Printable, letters_of_any_language_stay) { EXPECT_EQ(printable("Ünï 歩く 🦊"), "Ünï 歩く 🦊"); }

TEST(Printable, control_characters_become_question_marks) {
  EXPECT_EQ(printable("\x1b[31m\n\x7f"), "?[31m??");
  EXPECT_EQ(printable("\xc2\x9b"), "??");  // U+009B begins an escape sequence of the terminal, as the two characters ESC [ do
}

TEST(Printable, bytes_that_are_not_utf8_become_question_marks) {
  EXPECT_EQ(printable("a\xff\xc0\xaf z"), "a??? z");
  EXPECT_EQ(printable("cut \xe6\xad"), "cut ??");
}

TEST(Printable, text_beyond_60_characters_is_cut_between_characters) {
  std::string sixty, more;
  for (int i = 0; i < 60; ++i) sixty += "é";
  EXPECT_EQ(printable(sixty), sixty);
  EXPECT_EQ(printable(sixty + "é"), sixty + "...");
}

TEST(Printable, lines_have_no_control_characters) {
  const std::string hundred(100, 'a');
  EXPECT_EQ(printable_line(hundred + "\x1b]0;title\x07\r\n"), hundred + "?]0;title???");
  EXPECT_EQ(printable_line("a\xe2\x80\xae"
                           "b"),
            "a?"
            "??b");  // U+202E makes the terminal print the following text from right to left
}

TEST(Printable, shown_has_quotes) { EXPECT_EQ(shown("a"), "'a'"); }

TEST(ShellWord, plain_paths_stay_and_others_are_quoted) {
  EXPECT_EQ(shell_word("out/a_0.75-b.mp4"), "out/a_0.75-b.mp4");
  EXPECT_EQ(shell_word("my film"), "'my film'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("a;b"), "'a;b'");
}

}  // namespace
}  // namespace lippmann
