#include "report/render_figures.hpp"

#include <gmock/gmock.h>

#include "report/render_summary.hpp"
#include "report/reports.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

test::OrderedJson some_report() {
  return test::report_of_frames("copy", {test::key_frame(0), test::in_between_frame(1), test::in_between_frame(2)});
}

std::string figure(const RenderFigures& render, const std::string& name) {
  for (const SummaryFigure& one : render_summary(render))
    if (one.name == name) return one.value + " | " + one.why;
  return "(none)";
}

TEST(RenderFigures, a_complete_report_has_no_notes) {
  const RenderFigures render = test::figures_of(some_report());
  EXPECT_THAT(render.missing, IsEmpty());
  EXPECT_EQ(render.title, "somewhere");
  EXPECT_EQ(render.pixels, test::kPixels);
  EXPECT_EQ(render.frames.size(), 3u);
  ASSERT_EQ(render.runs.size(), 1u);
  EXPECT_EQ(render.runs[0].host, "workbench");
}

TEST(RenderFigures, a_summary_has_the_totals) {
  const RenderFigures render = test::figures_of(some_report());
  EXPECT_EQ(figure(render, "frames"), "3 | 2 in-between, 1 key");
  EXPECT_EQ(figure(render, "CPU time per frame"), "1.00 s | 3.00 s in all");
  EXPECT_EQ(figure(render, "CPU time saved"), "50.0 % | compared with frames traced in full; source frames are counted");
  EXPECT_EQ(figure(render, "pixels traced"), "46.7 % | 53.3 % copied");
  EXPECT_EQ(figure(render, "rays per frame"), "173 | 1.73 per pixel");
  EXPECT_EQ(figure(render, "lowest PSNR"), "– | all pixels are traced or exact copies");
}

TEST(RenderFigures, source_frames_are_counted) {
  test::OrderedJson report = some_report();
  report["totals"]["cpu_seconds"] = 5.0, report["totals"]["source_frames"] = 1;
  const RenderFigures render = test::figures_of(report);
  EXPECT_EQ(figure(render, "CPU time per frame"), "1.67 s | 5.00 s in all, with 1 source frames");
  EXPECT_NEAR(total_saving(render).value(), 1.0 - 5.0 / 3.0 / 2.0, 1e-12);
}

TEST(RenderFigures, the_worst_frame_has_the_lowest_bound) {
  test::OrderedJson report = test::report_of_frames("interpolate", {test::in_between_frame(1), test::in_between_frame(2)});
  report["frames"][0]["estimated_psnr_db"] = 36.0, report["frames"][0]["psnr_at_least_db"] = 35.25;
  report["frames"][1]["estimated_psnr_db"] = 37.0, report["frames"][1]["psnr_at_least_db"] = 35.0;
  EXPECT_EQ(figure(test::figures_of(report), "lowest PSNR"), "35.00 dB | at least, at 95 % confidence; frame 2");
}

TEST(RenderFigures, frames_are_sorted) {
  const test::OrderedJson report = test::report_of_frames("none", {test::key_frame(7), test::key_frame(2)});
  EXPECT_EQ(test::figures_of(report).frames.front().frame, 2);
}

TEST(RenderFigures, frames_without_min_psnr_are_not_measured) {
  const test::OrderedJson report = test::report_of_frames("interpolate", {test::in_between_frame(1)});
  EXPECT_THAT(figure(test::figures_of(report), "lowest PSNR"), HasSubstr("the error was not measured"));
}

TEST(RenderFigures, a_stopped_render_says_so) {
  test::OrderedJson report = test::report_of_frames("none", {});
  report["interrupted"] = true, report["runs"] = test::OrderedJson::array();
  EXPECT_THAT(test::figures_of(report).missing, ElementsAre(HasSubstr("was stopped"), HasSubstr("No frame is finished"),
                                                            HasSubstr("No run has recorded its end")));
}

TEST(RenderFigures, invalid_parts_are_named) {
  test::OrderedJson report = some_report();
  report["frames"][1].erase("rays");
  report["optics"] = 7;
  report.erase("settings"), report.erase("totals");
  const RenderFigures render = test::figures_of(report);
  EXPECT_EQ(render.frames.size(), 2u);
  EXPECT_EQ(render.cpu_seconds, 2.5);
  EXPECT_THAT(render.missing, ElementsAre(HasSubstr("settings are missing"), HasSubstr("1 frame of the report lacks"),
                                          HasSubstr("totals are missing"), HasSubstr("optics cannot be read")));
}

TEST(RenderFigures, a_report_needs_frames) {
  EXPECT_THAT(test::error_message([] {
                render_figures({{"version", "1"}}, "a/report.json");
              }),
              HasSubstr("a/report.json: lists no frames"));
}

}  // namespace
}  // namespace lippmann
