#include <gmock/gmock.h>

#include <cmath>

#include "calibrations.hpp"
#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::Json;
using testing::AllOf;
using testing::HasSubstr;

std::string message_of(const std::string& text) {
  return test::error_message([&] { display_from_calibration(text, "visual.json"); });
}

TEST(BadCalibration, invalid_values_are_refused_by_their_key) {
  for (const auto& [key, value] : std::vector<std::pair<const char*, Json>>{
           {"pitch", 0.0},
           {"pitch", -52.0},
           {"pitch", 1e300},
           {"pitch", "52"},
           {"pitch", Json()},
           {"pitch", {{"value", {{"value", 52.0}}}}},
           {"slope", 0},
           {"slope", 1e-9},
           {"slope", true},
           {"center", Json::array()},
           {"center", 1e17},
           {"DPI", 0.0},
           {"DPI", -1},
           {"screenW", 0},
           {"screenW", 1536.5},
           {"screenH", 1e12},
           {"viewCone", 0.0},
           {"viewCone", 180.0},
           {"verticalAngle", 1e9},
           {"flipImageX", "yes"},
           {"flip", "both"},
           {"CellPatternMode", 5},
           {"CellPatternMode", -1},
           {"configVersion", 3},
           {"subpixelCells", 3},
           {"subpixelCells", {1, 2}},
           {"subpixelCells", Json::array({Json::object()})},
       }) {
    Json json = test::portrait_calibration();
    json[key] = value;
    EXPECT_THAT(message_of(json.dump()), AllOf(HasSubstr("visual.json"), HasSubstr(key))) << key << " " << value;
    if (value.is_structured()) continue;
    json[key] = Json{{"value", value}};
    EXPECT_THAT(message_of(json.dump()), HasSubstr(key)) << key << " {" << value << "}";
  }
}

TEST(BadCalibration, missing_pitch_slope_or_center_is_refused) {
  for (const char* key : {"pitch", "slope", "center"}) {
    Json json = test::portrait_calibration();
    json.erase(key);
    EXPECT_THAT(message_of(json.dump()), AllOf(HasSubstr(key), HasSubstr("missing")));
  }
}

TEST(BadCalibration, narrow_lenses_and_large_panels_are_refused) {
  Json json = test::portrait_calibration();
  json["pitch"] = 2000.0;
  EXPECT_THAT(message_of(json.dump()), HasSubstr("periods"));
  json = test::portrait_calibration();
  json["screenW"] = 60000, json["screenH"] = 60000;
  EXPECT_THAT(message_of(json.dump()), HasSubstr("panel"));
}

TEST(BadCalibration, too_many_cells_are_refused) {
  Json json = test::portrait_calibration();
  for (int i = 0; i < 9; ++i) json["subpixelCells"].push_back(test::cell(0, 0, 0, 0, 0, 0));
  EXPECT_THAT(message_of(json.dump()), HasSubstr("at most 8"));
}

TEST(BadCalibration, every_truncation_is_one_error) {
  const std::string text = test::portrait_calibration().dump(1);
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    EXPECT_THAT(message_of(text.substr(0, length)), HasSubstr("visual.json:")) << length;
}

TEST(BadCalibration, other_text_is_refused) {
  for (const char* text : {"", "null", "[]", "52", "\"LKG\"", "{\"pitch\": NaN}", "{\"pitch\": 1e999}", "\xff\xfe{}", "{} {}"})
    EXPECT_THAT(message_of(text), HasSubstr("visual.json")) << text;
  EXPECT_THAT(message_of(std::string(100'000, '[')), HasSubstr("nested too deep"));
  EXPECT_THAT(message_of("{\"a\":" + std::string(50, '{')), HasSubstr("nested too deep"));
  EXPECT_THAT(message_of(std::string((1 << 20) + 1, ' ')), HasSubstr("bytes"));
}

TEST(BadCalibration, brackets_in_texts_are_not_nesting) {
  Json json = test::portrait_calibration();
  json["note"] = std::string(100, '[') + "\\\"" + std::string(100, '{');
  EXPECT_EQ(message_of(json.dump()), "(no Error)");
}

std::string message_of_toml(const std::string& text) {
  return test::error_message([&] { display_from_toml(text, "mine.toml"); });
}

TEST(BadDisplayFile, keys_and_values_are_refused_by_their_name) {
  const std::string sheet = "kind = \"lenticular-sheet\"\npixels = [600, 400]\ndpi = 600\nview_cone_deg = 40\n";
  const std::string lenses = "[lenses]\npitch_mm = 0.5\n";
  EXPECT_EQ(message_of_toml(sheet + lenses), "(no Error)");
  for (const auto& [text, part] : std::vector<std::pair<std::string, const char*>>{
           {"", "kind"},
           {"kind = \"lenticular\"", "'lenticular'"},
           {"base = \"portrat\"", "'portrait'"},
           {"base = \"portrait\"\nbase = \"go\"", "mine.toml:2"},
           {"base = \"portrait\"\ncolour = 3", "no such key"},
           {"base = \"portrait\"\nview_cone = 3", "'view_cone_deg'"},
           {"base = \"portrait\"\nview_cone_deg = nan", "view_cone_deg"},
           {"base = \"portrait\"\ndpi = 1979-05-27", "dpi"},
           {"base = \"portrait\"\n[quilt]\ntiles = [0, 6]", "quilt.tiles"},
           {"base = \"portrait\"\n[quilt]\ntiles = [8, 6, 1]", "quilt.tiles"},
           {"base = \"portrait\"\n[quilt]\nsize = [4, 6]", "quilt.size"},
           {"base = \"portrait\"\n[quilt]\naspect = 0", "quilt.aspect"},
           {"base = \"portrait\"\nquilt = 3", "'quilt'"},
           {"base = \"portrait\"\nserials = \"LKG\"", "serials"},
           {"base = \"portrait\"\n[video]\ncodec = \"mpeg2\"", "'mpeg2'"},
           {"base = \"portrait\"\n[calibration]\npatterns = \"both\"", "'both'"},
           {"base = \"portrait\"\n[calibration]\nDPI = 3", "calibration.DPI"},
           {sheet, "lenses"},
           {sheet + "[lenses]", "pitch_mm"},
           {sheet + lenses + "lenses_per_inch = 50", "one of the two"},
           {sheet + "[lenses]\nlenses_per_inch = 0", "lenses.lenses_per_inch"},
           {sheet + "[lenses]\npitch_mm = 0.001", "lens_pitch_mm"},
           {sheet + lenses + "slant_deg = 90", "lenses.slant_deg"},
           {"x = " + std::string(10'000, '['), "mine.toml"},
           {"\xff", "mine.toml"},
           {std::string("a = 1\0b", 7), "mine.toml"},
       })
    EXPECT_THAT(message_of_toml(text), HasSubstr(part)) << text.substr(0, 100);
}

}  // namespace
}  // namespace lippmann
