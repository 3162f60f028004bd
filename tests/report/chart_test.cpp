#include "report/chart.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::Not;

Chart line_chart(std::vector<std::optional<double>> values) {
  Chart chart{"Time", "s"};
  for (std::size_t i = 0; i < values.size(); ++i) chart.frames.push_back(static_cast<int>(2 * i));
  chart.series = {{"of frames", 3, std::move(values)}};
  return chart;
}

TEST(Chart, data_are_json) {
  Chart chart = line_chart({4.0, std::nullopt, 1.0 / 3.0});
  chart.starts_at_zero = false, chart.levels = {{"goal", 2.5}}, chart.top = 100.0;
  EXPECT_THAT(chart_html(chart),
              HasSubstr(R"(<script type="application/json">{"title":"Time","unit":"s","frames":[0,2,4],)"
                        R"("series":[{"name":"of frames","color":3,"values":[4.0,null,0.333333]}],)"
                        R"("levels":[{"name":"goal","value":2.5}],"stacked":false,"from_zero":false,"top":100.0}</script>)"));
}

TEST(Chart, bars_start_at_zero) {
  Chart chart = line_chart({25.0});
  chart.is_stacked = true, chart.starts_at_zero = false;
  EXPECT_THAT(chart_html(chart), HasSubstr(R"("stacked":true,"from_zero":true,"top":null)"));
}

TEST(Chart, infinite_values_are_unknown) {
  EXPECT_THAT(chart_html(line_chart({std::numeric_limits<double>::infinity(), 2.0})), HasSubstr("[null,2.0]"));
}

TEST(Chart, charts_without_values_are_left_out) {
  EXPECT_EQ(charts_html({line_chart({std::nullopt, std::numeric_limits<double>::quiet_NaN()}), Chart{}}), "");
}

TEST(Chart, names_cannot_become_markup) {
  Chart chart = line_chart({1.0});
  chart.title = "<i>", chart.unit = "<b2>", chart.series[0].name = "</script><img>", chart.levels = {{"<!--<u>", 0.5}};
  const std::string html = chart_html(chart);
  for (const char* tag : {"<i>", "<b2>", "<img", "<u>", "<!--"}) EXPECT_THAT(html, Not(HasSubstr(tag)));
}

}  // namespace
}  // namespace lippmann
