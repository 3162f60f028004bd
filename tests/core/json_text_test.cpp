#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/json_text.hpp"

namespace lippmann {
namespace {

TEST(JsonText, keys_keep_their_order) {
  const std::string text = R"({"z":1,"a":[true,null]})";
  EXPECT_EQ(json_to_text(json_from_text(text), -1), text);
}

TEST(JsonText, lines_are_indented) { EXPECT_EQ(json_to_text(json_from_text(R"({"a":1})")), "{\n  \"a\": 1\n}"); }

TEST(JsonText, invalid_json_is_discarded) {
  EXPECT_TRUE(json_from_text("{\"a\":").is_discarded());
  EXPECT_TRUE(json_from_text("").is_discarded());
}

TEST(JsonText, errors_name_member_and_word) {
  const auto error = [](const char* text) { return std::string(json_error(text, "a.json").what()); };
  EXPECT_EQ(error(R"({"frames": [{"m": [[1, 2]]}, {"m": [[1, 2], [3, NaN]]}]})"),
            "a.json: frames[1].m[1][1]: 'NaN' is not JSON; accepted: JSON with finite numbers");
  EXPECT_EQ(error(R"({"a": {"b": 1e400}})"), "a.json: a.b: '1e400' is not JSON; accepted: JSON with finite numbers");
  EXPECT_EQ(error(R"([-Infinity])"), "a.json: [0]: '-Infinity' is not JSON; accepted: JSON with finite numbers");
  EXPECT_EQ(error("{\"a\": [1,"), "a.json: a[1]: is not JSON: it ends too early");
  EXPECT_EQ(error("!"), "a.json: '!' is not JSON; accepted: JSON with finite numbers");
  EXPECT_EQ(error(""), "a.json: is not JSON: it ends too early");
}

TEST(JsonText, invalid_utf8_is_replaced) { EXPECT_EQ(json_to_text(nlohmann::ordered_json("a\xff"), -1), "\"a\xEF\xBF\xBD\""); }

}  // namespace
}  // namespace lippmann
