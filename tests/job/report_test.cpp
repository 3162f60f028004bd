#include "job/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/sample_frame.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

TEST(Report, fitted_view_is_described) {
  RenderReport report;
  report.view = "The view is fitted to 'Desk'.";
  EXPECT_EQ(to_json(report)["view"], report.view);
}

TEST(Report, totals_are_sums_over_the_frames) {
  RenderReport report;
  report.frames = {test::sample_frame(), test::sample_frame()};
  const Json totals = to_json(report)["totals"];
  EXPECT_EQ(totals["seconds"], 1.0);
  EXPECT_EQ(totals["cpu_seconds"], 1.5);
  EXPECT_EQ(totals["frames"], 2);
  EXPECT_EQ(totals["rays"], (Json{{"primary", 200}, {"shadow", 400}, {"reflection", 60}, {"indirect", 8}}));
}

TEST(Report, settings_have_json_types) {
  RenderReport report;
  report.params.sampling.spp = 4;
  report.params.optics.lenses = {32, 0};
  report.params.output.video = {"a.mp4"};
  const Json settings = to_json(report)["settings"];
  EXPECT_EQ(settings["spp"], 4);
  EXPECT_EQ(settings["lenses"], "32");
  EXPECT_EQ(settings["resume"], false);
  EXPECT_EQ(settings["video"], Json::array({"a.mp4"}));
  EXPECT_TRUE(settings["size"].is_null());
}

TEST(Report, infinite_lengths_are_null) {
  RenderReport report;
  report.optics.model = LenticularSheet{};
  EXPECT_TRUE(to_json(report)["optics"]["viewing_distance_mm"].is_null());
  EXPECT_TRUE(Json::accept(to_json(report).dump()));
}

}  // namespace
}  // namespace lippmann
