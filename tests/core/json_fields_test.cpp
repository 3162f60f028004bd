#include "core/json_fields.hpp"

#include <gmock/gmock.h>

#include "support/error_message.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const Json& document() {
  static const Json json = Json::parse(R"({"n": 2.5, "i": 3, "null": null, "t": "ab", "on": true, "zero": 0,
                                           "pair": [1, 2.5], "sizes": [4, 5], "texts": ["x", "y"], "in": {"n": 7}})");
  return json;
}

const JsonFields& fields() {
  static const JsonFields fields(document(), "a.json", "");
  return fields;
}

TEST(JsonFields, members_of_every_kind_are_read) {
  EXPECT_EQ(fields().number("n"), 2.5);
  EXPECT_EQ(fields().float_number("n"), 2.5f);
  EXPECT_EQ(fields().whole("i", kAnyCount), 3);
  EXPECT_EQ(fields().text("t"), "ab");
  EXPECT_TRUE(fields().flag_or("on", false));
  EXPECT_FALSE(fields().flag_or("zero", true));
  EXPECT_EQ(fields().pair("pair"), glm::dvec2(1.0, 2.5));
  EXPECT_EQ(fields().whole_pair("sizes", kAnyCount), Vec2i(4, 5));
  EXPECT_EQ(fields().numbers("pair", 2), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(fields().texts_or_none("texts"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(fields().word("t", {"a", "ab"}), 1u);
  EXPECT_EQ(fields().inner("in").whole("n", kAnyCount), 7);
}

TEST(JsonFields, missing_or_null_gives_the_default) {
  for (const char* key : {"null", "none"}) {
    EXPECT_FALSE(fields().has(key));
    EXPECT_EQ(fields().number_or(key, kAnyNumber, 4.0), 4.0);
    EXPECT_EQ(fields().whole_or(key, kAnyCount, 4), 4);
    EXPECT_EQ(fields().text_or(key, "c"), "c");
    EXPECT_TRUE(fields().flag_or(key, true));
    EXPECT_EQ(fields().word_or(key, {"a"}, 5), 5u);
    EXPECT_TRUE(fields().texts_or_none(key).empty());
  }
}

TEST(JsonFields, null_is_infinity) {
  EXPECT_EQ(fields().float_or_infinity("null"), kInfinity);
  EXPECT_EQ(fields().float_or_infinity("n"), 2.5f);
  EXPECT_THAT(test::error_message([] { fields().float_or_infinity("none"); }), HasSubstr("a.json: none: is missing"));
  EXPECT_EQ(finite_or_null(std::numeric_limits<double>::infinity()), Json(nullptr));
}

TEST(JsonFields, several_missing_members_are_named_at_once) {
  const auto message = [](const std::vector<std::string_view>& keys) {
    return test::error_message([&] { fields().require(keys); });
  };
  EXPECT_THAT(message({"n", "none", "null", "more"}), HasSubstr("a.json: none, more: are missing"));
  EXPECT_THAT(message({"n", "none", "more"}), HasSubstr("all of n, none, more"));
  EXPECT_NO_THROW(fields().require({"n", "null", "none"}));
}

TEST(JsonFields, errors_name_file_object_key_and_accepted) {
  const auto message = [](const auto& read) { return test::error_message([&] { read(fields()); }); };
  EXPECT_THAT(message([](const JsonFields& f) { f.inner("in").number("n", {0.0, 2.0}); }), HasSubstr("a.json: in.n: is 7"));
  EXPECT_THAT(message([](const JsonFields& f) { f.inner("in").number("n", {0.0, 2.0}); }), HasSubstr("from 0 to 2"));
  EXPECT_THAT(message([](const JsonFields& f) { f.number("t"); }), HasSubstr("t: is not a number"));
  EXPECT_THAT(message([](const JsonFields& f) { f.whole("n", kAnyCount); }), HasSubstr("n: is 2.5"));
  EXPECT_THAT(message([](const JsonFields& f) { f.text("n"); }), HasSubstr("n: is not a text"));
  EXPECT_THAT(message([](const JsonFields& f) { f.pair("texts"); }), HasSubstr("texts: is not a number"));
  EXPECT_THAT(message([](const JsonFields& f) { f.numbers("pair", 3); }), HasSubstr("a list of 3 numbers"));
  EXPECT_THAT(message([](const JsonFields& f) { f.whole_pair("pair", kAnyCount); }), HasSubstr("pair: is 2.5"));
  EXPECT_THAT(message([](const JsonFields& f) { f.word("t", {"a", "b"}); }), HasSubstr("one of a, b"));
  EXPECT_THAT(message([](const JsonFields& f) { f.inner("n"); }), HasSubstr("'n' is not an object"));
  EXPECT_THAT(message([](const JsonFields& f) { f.inner("in").allow_only({"m"}); }), HasSubstr("in.n: there is no such key"));
}

TEST(JsonFields, unread_keys_are_refused) {
  const Json json = Json::parse(R"({"gap": 1, "gpa": 2})");
  const JsonFields read(json, "", "");
  read.number("gap");
  EXPECT_THAT(test::error_message([&] { read.allow_read(); }), HasSubstr("gpa: there is no such key, did you mean 'gap'?"));
  EXPECT_TRUE(read.has("gpa"));
  EXPECT_NO_THROW(read.allow_read());
}

}  // namespace
}  // namespace lippmann
