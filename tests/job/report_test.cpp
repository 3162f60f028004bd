#include "job/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

FrameReport some_frame() {
  FrameReport frame;
  frame.frame = 7;
  frame.seconds = 0.5;
  frame.cpu_seconds = 0.75;
  frame.rays = {100, 200, 30, 4};
  frame.estimated_psnr_db = 48.5;
  return frame;
}

TEST(Report, frame_written_and_read_is_the_same) {
  const Json json = to_json(some_frame());
  const auto back = frame_report_from_json(json);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(to_json(*back), json);
}

TEST(Report, report_says_what_the_view_was_fitted_to) {
  RenderReport report;
  report.view = "The view is fitted to 'Desk'.";
  EXPECT_EQ(to_json(report)["view"], report.view);
}

FrameReport shared_frame() {
  FrameReport frame = some_frame();
  frame.kind = "shared";
  frame.psnr_at_least_db = 47.25;
  frame.estimated_block_psnr_db = 60.5;
  return frame;
}

TEST(Report, shared_frame_written_and_read_keeps_its_errors) {
  const auto back = frame_report_from_json(to_json(shared_frame()));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->kind, "shared");
  EXPECT_EQ(back->estimated_psnr_db, 48.5);
  EXPECT_EQ(back->psnr_at_least_db, 47.25);
  EXPECT_EQ(back->estimated_block_psnr_db, 60.5);
}

TEST(Report, shared_frame_without_one_of_its_errors_is_none) {
  for (const char* key : {"estimated_psnr_db", "psnr_at_least_db", "estimated_block_psnr_db"}) {
    Json json = to_json(shared_frame());
    json[key] = nullptr;
    EXPECT_FALSE(frame_report_from_json(json).has_value()) << key;
    json["kind"] = "full";
    EXPECT_TRUE(frame_report_from_json(json).has_value()) << key;
  }
}

TEST(Report, frame_without_a_key_or_with_a_wrong_type_is_none) {
  Json json = to_json(some_frame());
  json.erase("rays");
  EXPECT_FALSE(frame_report_from_json(json).has_value());
  EXPECT_FALSE(frame_report_from_json("frame").has_value());
  EXPECT_FALSE(frame_report_from_json(Json::value_t::discarded).has_value());
}

TEST(Report, totals_are_sums_over_the_frames) {
  RenderReport report;
  report.frames = {some_frame(), some_frame()};
  const Json totals = to_json(report)["totals"];
  EXPECT_EQ(totals["seconds"], 1.0);
  EXPECT_EQ(totals["cpu_seconds"], 1.5);
  EXPECT_EQ(totals["frames"], 2);
  EXPECT_EQ(totals["rays"], (Json{{"primary", 200}, {"shadow", 400}, {"reflection", 60}, {"indirect", 8}}));
}

TEST(Report, settings_have_json_types_and_null_for_what_is_not_said) {
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
  EXPECT_NO_THROW(Json::parse(to_json(report).dump()));
}

}  // namespace
}  // namespace lippmann
