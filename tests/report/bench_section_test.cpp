#include "report/bench_section.hpp"

#include <gmock/gmock.h>

#include "report/reports.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

test::OrderedJson some_result() {
  return {{"bench", "reuse"},
          {"machine", {{"cpu", "Some CPU"}, {"threads", 2}}},
          {"rows",
           {{{"scene", "room"}, {"saving_total", 0.25}}, {{"scene", "<tree>"}, {"saving_total", 0.5}, {"psnr_db", nullptr}}}},
          {"passed_checks", 12}};
}

TEST(BenchSection, rows_become_a_table_with_bars) {
  const std::string html = bench_section(some_result(), "x.json");
  EXPECT_THAT(html, HasSubstr("<h2>bench reuse</h2>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">room</th><td>0.25<i class=\"meter\" style=\"width:50.0%\"></i></td>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">&lt;tree&gt;</th><td>0.5<i class=\"meter\" style=\"width:100.0%\"></i></td>"));
  EXPECT_THAT(html, HasSubstr("<dt>cpu</dt><dd>Some CPU</dd>"));
  EXPECT_THAT(html, HasSubstr("12 checks of results passed."));
}

TEST(BenchSection, invalid_rows_are_refused) {
  test::OrderedJson result = some_result();
  result["rows"] = {1, 2};
  EXPECT_TRUE(is_bench_result(result));
  EXPECT_THAT(test::error_message([&] { bench_section(result, "x.json"); }),
              HasSubstr("x.json: its rows are not a list of objects"));
}

TEST(BenchSection, a_renders_report_is_not_a_benchmarks) { EXPECT_FALSE(is_bench_result(test::report_of_frames("none", {}))); }

}  // namespace
}  // namespace lippmann
