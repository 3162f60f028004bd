#include "view/page_display.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Display small_panel() {
  Display display;
  display.name = "small", display.pixels = {300, 200}, display.dpi = 100.0;
  display.calibration.pitch = 10.0, display.calibration.slope = -2.0, display.calibration.center = 0.25;
  return display;
}

// Lens periods: P = pitch * width / dpi * cos(atan(1 / slope)) = 10 * 300 / 100 * cos(atan(1/2)). Tilt: T = height /
// (width * slope) = 200 / (300 * -2). The page measures x at the middles of sub-pixels, a third of a pixel further left
// than the calibration. Therefore, the page's centre is lower by P / (3 * 300).
TEST(PageDisplay, phases_follow_the_calibration) {
  const nlohmann::ordered_json json = page_display_json({small_panel(), {ViewFilter::kGaussian, 0.75}});
  const double periods = 30.0 * 2.0 / std::sqrt(5.0);
  EXPECT_EQ(json["name"], "small");
  EXPECT_EQ(json["pixels"], (nlohmann::ordered_json{300, 200}));
  EXPECT_NEAR(json["panel"]["periods"].get<double>(), periods, 1e-12);
  EXPECT_NEAR(json["panel"]["tilt"].get<double>(), -1.0 / 3.0, 1e-12);
  EXPECT_NEAR(json["panel"]["center"].get<double>(), 0.25 - periods / 900.0, 1e-12);
  EXPECT_EQ(json["panel"]["inverted"], true);
  EXPECT_EQ(json["filter"], "gaussian");
  EXPECT_EQ(json["sigma_views"], 0.75);
}

TEST(PageDisplay, cells_are_listed_by_row_and_column) {
  Display display = small_panel();
  display.calibration.cells = {SubPixelCell{Vec2f(0.5f, 0.25f), Vec2f(0.0f), Vec2f(-0.5f, 0.0f)}, SubPixelCell{}};
  display.calibration.cell_pattern = 1;
  const nlohmann::ordered_json cells = page_display_json({display, {}})["panel"]["sub_pixels"];
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[0][0][0], (nlohmann::ordered_json{0.5, 0.25}));
  EXPECT_EQ(cells[0][0][2], (nlohmann::ordered_json{-0.5, 0.0}));
  EXPECT_EQ(cells[0][1][0], (nlohmann::ordered_json{0.0, 0.0}));
  EXPECT_EQ(cells[1][1][0], (nlohmann::ordered_json{0.5, 0.25}));
}

TEST(PageDisplay, several_rows_of_views_are_refused) {
  PageFacts facts;
  facts.title = "grid", facts.grid = {5, 1};
  require_one_row(facts);
  facts.grid = {5, 3};
  EXPECT_THAT(test::error_message([&] { require_one_row(facts); }),
              AllOf(HasSubstr("grid has 5x3 views"), HasSubstr("one row")));
}

TEST(PageDisplay, dropped_calibration_equals_the_tools) {
  const PageDisplay dropped = dropped_calibration(
      R"({"serial":"LKG-P1","pitch":{"value":52.5},"slope":-7,"center":0.5,"screenW":120,"screenH":90,"DPI":324})",
      {ViewFilter::kLinear, 0.5});
  EXPECT_EQ(dropped.display.name, "LKG-P1");
  EXPECT_EQ(dropped.display.pixels, Vec2i(120, 90));
  EXPECT_EQ(dropped.display.calibration.pitch, 52.5);
  EXPECT_EQ(dropped.interlace.filter, ViewFilter::kLinear);
  for (const char* text :
       {"", "no JSON", "{}", "[1]", R"({"pitch":50,"slope":0,"center":0,"DPI":300,"screenW":9,"screenH":9})"})
    EXPECT_THAT(test::error_message([&] { dropped_calibration(text, {}); }), HasSubstr("the calibration")) << text;
}

}  // namespace
}  // namespace lippmann
