#include "lippmann/display/load_display.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "calibrations.hpp"
#include "display/display_json.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::Json;
using testing::HasSubstr;

Display calibrated(const Json& json) { return display_from_calibration(json.dump(), "visual.json"); }

TEST(Presets, all_are_valid_described_and_found_by_name) {
  std::set<std::string> names;
  for (const Display& display : display_presets()) {
    EXPECT_TRUE(names.insert(display.name).second) << display.name;
    EXPECT_FALSE(display.description.empty()) << display.name;
    EXPECT_NO_THROW(validate(native_optics(display))) << display.name;
    EXPECT_EQ(load_display(display.name).description, display.description);
    if (display.kind == DisplayKind::kSlantedPanel) {
      ASSERT_TRUE(display.quilt.has_value()) << display.name;
      EXPECT_NEAR(display.quilt->aspect, static_cast<double>(display.pixels.x) / display.pixels.y, 1e-4) << display.name;
    }
  }
  EXPECT_GE(names.size(), 20u);
}

TEST(Presets, quilt_of_the_16_inch_matches_devices) {
  const Display display = load_display("16-landscape");
  EXPECT_EQ(display.quilt, (DisplayQuilt{8, 6, 7680, 4320, 1.7778}));
  EXPECT_EQ(display.pixels, Vec2i(3840, 2160)) << "the panel is not the quilt";
  EXPECT_EQ(display.view_cone_deg, 50.0);
}

TEST(Presets, rows_of_the_devices_table) {
  const Display go = load_display("Looking-Glass-Go"), landscape = load_display("32-landscape");
  EXPECT_EQ(go.pixels, Vec2i(1440, 2560));
  EXPECT_EQ(go.calibration.pitch, 80.7);
  EXPECT_EQ(go.calibration.slope, -6.3);
  EXPECT_EQ(go.calibration.center, -0.3);
  EXPECT_EQ(go.view_cone_deg, 54.0);
  EXPECT_EQ(go.quilt, (DisplayQuilt{11, 6, 4092, 4092, 0.5625}));
  EXPECT_FALSE(go.video.quilts);
  EXPECT_EQ(landscape.quilt, (DisplayQuilt{7, 7, 8190, 8190, 1.7778}));
  EXPECT_EQ(landscape.video.codec, "hevc");
}

TEST(Presets, misspelt_name_suggests_the_nearest) {
  EXPECT_THAT(test::error_message([] { load_display("portrat"); }), HasSubstr("'portrait'"));
  EXPECT_THAT(test::error_message([] { load_display("looking-glass-gi"); }), HasSubstr("'looking-glass-go'"));
}

TEST(CalibrationFile, plain_and_wrapped_numbers_are_equal) {
  Json plain = test::portrait_calibration();
  for (auto& [key, value] : plain.items())
    if (value.is_object()) value = Json(value["value"]);
  EXPECT_EQ(display_json(calibrated(plain)), display_json(calibrated(test::portrait_calibration())));
  EXPECT_EQ(calibrated(plain).calibration.pitch, 52.5);
  EXPECT_EQ(calibrated(plain).calibration.center, 0.125);
}

TEST(CalibrationFile, one_enclosing_table_is_allowed) {
  const Json bare = test::portrait_calibration();
  for (const char* table : {"calibration", "config"})
    EXPECT_EQ(display_json(calibrated(Json{{table, bare}})), display_json(calibrated(bare))) << table;
}

TEST(CalibrationFile, files_of_other_content_are_named) {
  const test::TempDir dir;
  for (const char* name : {"a.json", "a.toml"}) {
    std::ofstream(dir / name) << "";
    EXPECT_THAT(test::error_message([&] { load_display((dir / name).string()); }), HasSubstr("is empty (0 bytes)"));
    std::ofstream(dir / name) << "<!DOCTYPE html><html></html>";
    EXPECT_THAT(test::error_message([&] { load_display((dir / name).string()); }), HasSubstr("web page"));
  }
}

TEST(CalibrationFile, missing_values_come_from_the_serial_numbers_preset) {
  const Json least{{"serial", "LKG-J00001"}, {"pitch", 44.75}, {"slope", -6.87}, {"center", 0.17}};
  const Display display = calibrated(least), preset = load_display("looking-glass-16-landscape");
  EXPECT_EQ(display.quilt, preset.quilt);
  EXPECT_EQ(display.pixels, preset.pixels);
  EXPECT_EQ(display.dpi, preset.dpi);
  EXPECT_EQ(display.view_cone_deg, 50.0);
  EXPECT_EQ(display.calibration.cells, preset.calibration.cells);
  EXPECT_EQ(display.calibration.pitch, 44.75);
  EXPECT_THAT(display.description, HasSubstr("LKG-J00001"));
}

TEST(CalibrationFile, own_values_override_the_presets) {
  Json json = test::portrait_calibration();
  json["serial"] = "LKG-J1";
  json["viewCone"] = 35.0;
  json["subpixelCells"] = Json::array({test::cell(-0.3, 0, 0, 0, 0.3, 0)});
  const Display display = calibrated(json);
  EXPECT_EQ(display.pixels, Vec2i(1536, 2048));
  EXPECT_EQ(display.view_cone_deg, 35.0);
  EXPECT_EQ(display.calibration.cells.size(), 1u);
  json["subpixelCells"] = Json::array();
  EXPECT_TRUE(calibrated(json).calibration.cells.empty());
}

TEST(CalibrationFile, unknown_device_needs_a_size) {
  Json json = test::portrait_calibration();
  json["serial"] = "DIY-1";
  json["somethingNew"] = {{"of", {1, 2, 3}}};
  EXPECT_EQ(calibrated(json).quilt, (DisplayQuilt{8, 6, 4096, 4096, 0.75}));
  json["screenW"] = 4096, json["screenH"] = 2048;
  EXPECT_EQ(calibrated(json).quilt, (DisplayQuilt{5, 9, 4096, 4096, 2.0}));
  for (const char* key : {"screenW", "screenH", "DPI"}) {
    Json lacking = json;
    lacking.erase(key);
    EXPECT_THAT(test::error_message([&] { calibrated(lacking); }), HasSubstr(key));
  }
}

TEST(DisplayFile, own_file_overrides_its_base) {
  const Display display = display_from_toml(R"(
    base = "portrait"
    view_cone_deg = 35.5
    [calibration]
    center = 0.25
    patterns = "rows"
    flip = "slope"
    [quilt]
    tiles = [4, 12])",
                                            "mine.toml");
  EXPECT_EQ(display.view_cone_deg, 35.5);
  EXPECT_EQ(display.calibration.center, 0.25);
  EXPECT_EQ(display.calibration.patterns, Calibration::Patterns::kRows);
  EXPECT_EQ(display.calibration.flip, Calibration::Flip::kSlope);
  EXPECT_EQ(display.calibration.pitch, 52.0);
  EXPECT_EQ(display.quilt, (DisplayQuilt{4, 12, 3360, 3360, 0.75}));
}

TEST(DisplayFile, whole_file_of_a_sheet) {
  const Display display = display_from_toml(R"(
    kind = "lenticular-sheet"
    pixels = [2400, 1200]
    dpi = 600
    view_cone_deg = 30
    viewing_distance_mm = 1000
    [lenses]
    pitch_mm = 0.5
    slant_deg = 9.5)",
                                            "mine.toml");
  const auto sheet = std::get<LenticularSheet>(native_optics(display).model);
  EXPECT_FLOAT_EQ(sheet.lens_pitch_mm, 0.5f);
  EXPECT_FLOAT_EQ(sheet.slant, radians(9.5f));
  EXPECT_FLOAT_EQ(sheet.viewing_distance_mm, 1000.0f);
  EXPECT_FALSE(display.quilt.has_value());
}

TEST(DisplayFile, extensions_decide_and_file_names_are_kept) {
  const test::TempDir dir;
  std::ofstream(dir / "desk.json") << test::portrait_calibration();
  std::ofstream(dir / "mine.toml") << "base = \"go\"\n";
  EXPECT_EQ(load_display((dir / "desk.json").string()).name, "desk");
  EXPECT_EQ(load_display((dir / "mine.toml").string()).name, "mine");
  EXPECT_THAT(test::error_message([&] { load_display((dir / "none.json").string()); }), HasSubstr("no such file"));
  EXPECT_THAT(test::error_message([&] { load_display(dir.path().string() + "/.toml"); }), HasSubstr(".toml"));
}

}  // namespace
}  // namespace lippmann
