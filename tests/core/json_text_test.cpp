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

TEST(JsonText, invalid_utf8_is_replaced) { EXPECT_EQ(json_to_text(nlohmann::ordered_json("a\xff"), -1), "\"a\xEF\xBF\xBD\""); }

}  // namespace
}  // namespace lippmann
