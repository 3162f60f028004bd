#include "report/report_page.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "image/png.hpp"
#include "report/reports.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

test::OrderedJson interpolated() {
  test::OrderedJson report =
      test::report_of_frames("interpolate", {test::key_frame(0), test::in_between_frame(1), test::in_between_frame(2)});
  report["frames"][1]["estimated_psnr_db"] = 36.0, report["frames"][1]["psnr_at_least_db"] = 35.5;
  report["frames"][2]["estimated_psnr_db"] = 37.0, report["frames"][2]["psnr_at_least_db"] = 36.5;
  report["settings"]["min-psnr"] = 35;
  return report;
}

std::string page_of(const std::vector<fs::path>& inputs) { return make_report_page(inputs, Context()).html; }

std::string chart_data(const std::string& page, const std::string& title) {
  const std::string begin = "<figcaption><b>" + title + "</b>";
  const std::size_t from = page.find(begin);
  if (from == std::string::npos) return "there is no chart: " + title;
  return page.substr(from, page.find("</figure>", from) - from);
}

std::string refusal_of(const std::vector<fs::path>& inputs) {
  return test::error_message([&] { make_report_page(inputs, Context()); });
}

TEST(ReportPage, psnr_chart_shows_the_papers_figure) {
  const test::TempDir dir;
  const std::string page = page_of({test::write_report_text(dir / "film", interpolated().dump())});
  EXPECT_THAT(page, HasSubstr("<h2>film <small>room, reuse interpolate</small></h2>"));
  EXPECT_THAT(chart_data(page, "PSNR, estimated from held-out pixels"),
              AllOf(HasSubstr(R"({"name":"the paper's 34.5 dB","value":34.5})"), HasSubstr(R"("name":"requested: 35 dB")"),
                    HasSubstr(R"({"name":"estimate","color":0,"values":[null,36.0,37.0]})"),
                    HasSubstr(R"~({"name":"at least (95 % confidence)","color":1,"values":[null,35.5,36.5]})~")));
  EXPECT_THAT(chart_data(page, "Where pixels come from"),
              AllOf(HasSubstr(R"({"name":"traced","color":0,"values":[100.0,15.0,15.0]})"),
                    HasSubstr(R"({"name":"interpolated","color":2,"values":[0.0,80.0,80.0]})"),
                    HasSubstr(R"({"name":"filled","color":3,"values":[0.0,5.0,5.0]})")));
  EXPECT_THAT(chart_data(page, "Rays per pixel"), AllOf(HasSubstr(R"({"name":"primary","color":0,"values":[1.0,0.15,0.15]})"),
                                                        HasSubstr(R"({"name":"shadow","color":2,"values":[2.0,0.3,0.3]})")));
  EXPECT_THAT(chart_data(page, "CPU time saved"), HasSubstr(R"("values":[null,75.0,75.0])"));
}

TEST(ReportPage, traced_frames_have_no_paper_line) {
  const test::TempDir dir;
  const std::string page =
      page_of({test::write_report_text(dir / "film", test::report_of_frames("none", {test::key_frame(0)}).dump())});
  EXPECT_THAT(page, Not(HasSubstr("34.5 dB")));
}

TEST(ReportPage, the_command_and_the_machine_are_shown) {
  const test::TempDir dir;
  const std::string page = page_of({test::write_report_text(dir / "film", interpolated().dump())});
  EXPECT_THAT(page, HasSubstr("<pre>lippmann render room --spp 4 --min-psnr 35</pre>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">workbench</th><td>Example 9000</td><td>2</td><td>1</td><td>3</td>"));
}

TEST(ReportPage, units_of_one_machine_share_a_row) {
  const test::TempDir dir;
  test::OrderedJson report = interpolated();
  for (int i = 0; i < 40; ++i) report["runs"].push_back(report["runs"][0]);
  report["runs"].push_back(report["runs"][0]);
  report["runs"].back()["host"] = "another";
  report["runs"].back().erase("cpu");  // earlier versions do not state the processor
  const std::string page = page_of({test::write_report_text(dir / "film", report.dump())});
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">workbench</th><td>Example 9000</td><td>2</td><td>41</td><td>123</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">another</th><td>–</td>"));
  EXPECT_THAT(page, HasSubstr("Times of different machines are not comparable"));
}

TEST(ReportPage, pictures_are_the_middle_views) {
  const test::TempDir dir;
  test::OrderedJson report = test::report_of_frames("none", {test::key_frame(0)});
  const fs::path folder = test::write_report_text(dir / "film", report.dump());
  write_png(folder / "frame_0000.png", test::noise_codes(10, 10));
  const std::string page = page_of({folder});
  EXPECT_EQ(test::count_of(page, "<img src=\"data:image/webp;base64,"), 1u);
  EXPECT_THAT(page, Not(HasSubstr("cannot be shown")));
}

TEST(ReportPage, a_folder_without_pictures_has_figures) {
  const test::TempDir dir;
  const std::string page = page_of({test::write_report_text(dir / "film", interpolated().dump())});
  EXPECT_THAT(page, HasSubstr("Some pictures cannot be shown: "));
  EXPECT_THAT(page, HasSubstr("contains no frames or views"));
  EXPECT_THAT(page, HasSubstr("Where pixels come from"));
}

TEST(ReportPage, names_cannot_become_markup) {
  const test::TempDir dir;
  test::OrderedJson report = interpolated();
  const std::string evil = "\"><script>alert(1)</script>";
  report["scene"] = report["view"] = report["light"] = report["version"] = report["reuse"] = evil;
  report["runs"][0]["host"] = report["runs"][0]["cpu"] = evil;
  report["settings"][evil] = evil;
  for (auto& frame : report["frames"]) frame["kind"] = evil;
  const fs::path folder = test::write_report_text(dir / "a<script>b", report.dump());
  const std::string page = page_of({folder, test::write_report_text(dir / "other", report.dump())});
  EXPECT_EQ(test::count_of(page, "<script"), test::count_of(page, "<script type=\"application/json\">") + 1);
  EXPECT_EQ(test::count_of(page, "<script>"), 1u);
  EXPECT_THAT(page, HasSubstr("a&lt;script&gt;b"));
}

TEST(ReportPage, nothing_is_loaded_and_one_script_runs) {
  const test::TempDir dir;
  const std::string page = page_of({test::write_report_text(dir / "film", interpolated().dump())});
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-"));
  EXPECT_EQ(test::count_of(page, "<script>"), 1u);
  for (const char* part : {"<link", "url(", " src=\"/", " href="}) EXPECT_THAT(page, Not(HasSubstr(part))) << part;
}

TEST(ReportPage, several_renders_stand_side_by_side) {
  const test::TempDir dir;
  const fs::path traced = test::write_report_text(
      dir / "traced", test::report_of_frames("none", {test::key_frame(0), test::key_frame(1), test::key_frame(2)}).dump());
  const fs::path made = test::write_report_text(dir / "made", interpolated().dump());
  const std::string page = page_of({traced, made});
  EXPECT_THAT(page, HasSubstr("<th scope=\"col\">traced</th><th scope=\"col\">made</th>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">reuse</th><td>none</td><td>interpolate</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">CPU time saved, compared with traced</th><td></td><td>50.0 %</td>"));
  EXPECT_THAT(chart_data(page, "CPU time saved"), HasSubstr(R"({"name":"made","color":1,"values":[0.0,75.0,75.0]})"));
  EXPECT_THAT(page, Not(HasSubstr("The frames differ")));
}

TEST(ReportPage, unfair_comparisons_are_named) {
  const test::TempDir dir;
  test::OrderedJson other = test::report_of_frames("none", {test::key_frame(5)});
  other["scene"] = "tree", other["runs"][0]["host"] = "another";
  const std::string page = page_of({test::write_report_text(dir / "a" / "film", interpolated().dump()),
                                    test::write_report_text(dir / "b" / "film", other.dump())});
  for (const char* part : {"The scenes differ.", "The frames differ", "The machines differ", "b/film/report.json"})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(page, Not(HasSubstr("differ in size")));
}

TEST(ReportPage, benchmarks_have_a_section) {
  const test::TempDir dir;
  std::ofstream(dir / "x.json")
      << R"({"bench": "rays", "machine": {}, "rows": [{"scene": "room", "ratio": 1.5}], "passed_checks": 3})";
  const std::string page = page_of({dir / "x.json", test::write_report_text(dir / "film", interpolated().dump())});
  EXPECT_THAT(page, HasSubstr("<h2>bench rays</h2>"));
  EXPECT_THAT(page, HasSubstr("<h2>film <small>"));
}

TEST(ReportPage, a_page_without_charts_has_no_script) {
  const test::TempDir dir;
  std::ofstream(dir / "x.json") << R"({"bench": "rays", "machine": {}, "rows": []})";
  EXPECT_THAT(page_of({dir / "x.json"}), Not(HasSubstr("<script")));
}

TEST(ReportPage, invalid_reports_are_refused_by_name) {
  const test::TempDir dir;
  EXPECT_THAT(refusal_of({dir / "nowhere"}), HasSubstr("nowhere: there is no such file"));
  EXPECT_THAT(refusal_of({test::write_report_text(dir / "cut", interpolated().dump().substr(0, 900))}),
              HasSubstr("report.json: is not JSON, or is truncated"));
  EXPECT_THAT(refusal_of({test::write_report_text(dir / "list", "[1]")}), HasSubstr("is not a JSON object"));
  EXPECT_THAT(refusal_of({test::write_report_text(dir / "other", "{}")}), HasSubstr("lists no frames"));
}

TEST(ReportPage, foreign_files_are_kept) {
  const test::TempDir dir;
  const ReportPage page = make_report_page({test::write_report_text(dir / "film", interpolated().dump())}, Context());
  write_report_page(page, dir / "new" / "page.html");
  write_report_page(page, dir / "new" / "page.html");
  EXPECT_EQ(test::file_bytes(dir / "new" / "page.html"), page.html);
  std::ofstream(dir / "thesis.html") << "mine";
  EXPECT_THAT(test::error_message([&] { write_report_page(page, dir / "thesis.html"); }),
              HasSubstr("exists and is not a report page"));
  EXPECT_EQ(test::file_bytes(dir / "thesis.html"), "mine");
}

TEST(ReportPage, default_page_depends_on_the_number_of_folders) {
  const test::TempDir dir;
  EXPECT_EQ(default_report_file({dir.path()}), dir / "report.html");
  EXPECT_EQ(default_report_file({dir.path(), dir.path()}), "report.html");
  EXPECT_EQ(default_report_file({dir / "report.json"}), "report.html");
}

}  // namespace
}  // namespace lippmann
