#include "report/figure_text.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(FigureText, seconds_have_three_digits_and_a_unit) {
  EXPECT_EQ(seconds_text(0.0), "0.00 ms");
  EXPECT_EQ(seconds_text(0.01234), "12.3 ms");
  EXPECT_EQ(seconds_text(0.9996), "1.00 s");
  EXPECT_EQ(seconds_text(12.34), "12.3 s");
  EXPECT_EQ(seconds_text(125.0), "2 min 5 s");
  EXPECT_EQ(seconds_text(11520.0), "3 h 12 min");
}

TEST(FigureText, counts_are_written_out_below_ten_thousand) {
  EXPECT_EQ(count_text(950.0), "950");
  EXPECT_EQ(count_text(12345.0), "12.3 k");
  EXPECT_EQ(count_text(1.25e6), "1.25 M");
  EXPECT_EQ(count_text(3.0e9), "3.00 G");
}

TEST(FigureText, unknown_values_are_a_dash) {
  EXPECT_EQ(percent_text(std::nullopt), kNotKnown);
  EXPECT_EQ(decibel_text(std::nullopt), kNotKnown);
  EXPECT_EQ(memory_text(0.0), kNotKnown);
  EXPECT_EQ(percent_text(-0.0421), "-4.2 %");
  EXPECT_EQ(decibel_text(34.5), "34.50 dB");
}

}  // namespace
}  // namespace lippmann
