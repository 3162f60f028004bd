#include "report/html.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Html, text_cannot_become_markup) {
  EXPECT_EQ(escaped("<b a='1' c=\"2\">&</b>"), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;&lt;/b&gt;");
}

TEST(Html, letters_stay_and_invalid_bytes_are_marked) {
  EXPECT_EQ(escaped("Häuser 家"), "Häuser 家");
  EXPECT_EQ(escaped("a\xff"
                    "b"),
            "a\xEF\xBF\xBD"
            "b");
}

TEST(Html, control_characters_become_spaces) { EXPECT_EQ(escaped(std::string("a\0b\x1b[31m\n", 9)), "a b [31m "); }

TEST(Html, first_cells_of_rows_are_headings) {
  const std::string table = table_html({{"frame", "kind"}, {{"3", "key"}}, "wide"});
  EXPECT_NE(table.find("<table class=\"wide\"><thead><tr><th scope=\"col\">frame</th><th scope=\"col\">kind</th></tr></thead>"
                       "<tbody><tr><th scope=\"row\">3</th><td>key</td></tr>"),
            std::string::npos)
      << table;
}

}  // namespace
}  // namespace lippmann
