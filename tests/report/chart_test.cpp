#include "report/chart.hpp"

#include <gmock/gmock.h>

#include "report/reports.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::Not;

Chart line_chart(std::vector<std::optional<double>> values) {
  Chart chart{"Time", "s"};
  for (std::size_t i = 0; i < values.size(); ++i) chart.slots.push_back(std::to_string(i));
  chart.series = {{"of frames", 3, std::move(values)}};
  return chart;
}

TEST(Chart, the_axis_has_steps_of_1_2_or_5) {
  const ChartAxis axis = chart_axis(line_chart({0.0, 3.1, 7.2}));
  EXPECT_EQ(axis.low, 0.0);
  EXPECT_EQ(axis.step, 2.0);
  EXPECT_EQ(axis.high, 8.0);
}

TEST(Chart, an_axis_that_need_not_begin_at_zero_holds_values_and_levels) {
  Chart chart = line_chart({41.3, 43.0});
  chart.starts_at_zero = false;
  chart.levels = {{"the paper's", 34.5}};
  const ChartAxis axis = chart_axis(chart);
  EXPECT_EQ(axis.step, 5.0);
  EXPECT_EQ(axis.low, 30.0);
  EXPECT_EQ(axis.high, 45.0);
}

TEST(Chart, equal_values_have_an_axis_of_some_length) {
  Chart chart = line_chart({40.0, 40.0});
  chart.starts_at_zero = false;
  const ChartAxis axis = chart_axis(chart);
  EXPECT_LE(axis.low, 40.0);
  EXPECT_GT(axis.high, 40.0);
}

TEST(Chart, lines_go_from_middle_to_middle_and_values_alone_are_dashes) {
  // 4 slots of 250 units; the axis ends at 8, so that 4 lies in the middle of 400 units.
  const std::string html = chart_html(line_chart({4.0, 8.0, std::nullopt, 0.0}));
  EXPECT_THAT(html, HasSubstr("class=\"line c3\" d=\"M125.0 200.0L375.0 0.0M812.5 400.0H937.5\""));
}

TEST(Chart, bars_stand_on_each_other) {
  Chart chart = line_chart({25.0});
  chart.is_stacked = true, chart.top = 100.0;
  chart.series.push_back({"others", 1, {75.0}});
  const std::string html = chart_html(chart);
  EXPECT_THAT(html, HasSubstr("class=\"bar c3\" d=\"M100.0 400.0H900.0V300.0H100.0Z\""));
  EXPECT_THAT(html, HasSubstr("class=\"bar c1\" d=\"M100.0 300.0H900.0V0.0H100.0Z\""));
}

TEST(Chart, pointing_at_a_frame_tells_its_figures) {
  EXPECT_THAT(chart_html(line_chart({4.0, 8.0})), HasSubstr("<title>Frame 1&#10;of frames: 8 s</title>"));
}

TEST(Chart, values_that_are_no_numbers_are_not_drawn) {
  const std::string html = chart_html(line_chart({std::numeric_limits<double>::infinity(), 2.0}));
  EXPECT_THAT(html, Not(HasSubstr("inf")));
  EXPECT_EQ(chart_html(line_chart({std::nullopt, std::nan("")})), "");
}

TEST(Chart, many_frames_have_no_more_places_to_point_at_than_pixels) {
  const std::string html = chart_html(line_chart(std::vector<std::optional<double>>(5000, 1.0)));
  EXPECT_EQ(test::count_of(html, "<title>"), 556u);  // every ninth of 5000
}

TEST(Chart, names_cannot_become_markup) {
  Chart chart = line_chart({1.0});
  chart.title = "<script>", chart.series[0].name = "<img>", chart.slots[0] = "<i>", chart.levels = {{"<u>", 0.5}};
  const std::string html = chart_html(chart);
  for (const char* tag : {"<script", "<img", "<i>", "<u>"}) EXPECT_THAT(html, Not(HasSubstr(tag)));
}

}  // namespace
}  // namespace lippmann
