#include "folder/frame_report_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/sample_frame.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

TEST(FrameReportJson, frame_round_trips) {
  const Json json = to_json(test::sample_frame());
  const auto back = frame_report_from_json(json);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(to_json(*back), json);
}

TEST(FrameReportJson, path_traced_frame_round_trips_with_errors) {
  FrameReport frame = test::sample_frame();
  frame.psnr_at_least_db = 47.25, frame.psnr_at_most_db = 50.5;
  const auto back = frame_report_from_json(to_json(frame));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->estimated_psnr_db, 48.5);
  EXPECT_EQ(back->psnr_at_least_db, 47.25);
  EXPECT_EQ(back->psnr_at_most_db, 50.5);
}

TEST(FrameReportJson, shared_frame_of_old_versions_is_full) {
  Json json = to_json(test::sample_frame());
  json["kind"] = "shared", json["estimated_block_psnr_db"] = 60.5;
  json.erase("psnr_at_most_db");
  const auto back = frame_report_from_json(json);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->kind, "full");
  EXPECT_EQ(back->estimated_psnr_db, 48.5);
  EXPECT_FALSE(back->psnr_at_most_db);
}

TEST(FrameReportJson, missing_keys_and_wrong_types_are_refused) {
  Json json = to_json(test::sample_frame());
  json.erase("rays");
  EXPECT_FALSE(frame_report_from_json(json).has_value());
  EXPECT_FALSE(frame_report_from_json("frame").has_value());
  EXPECT_FALSE(frame_report_from_json(Json::value_t::discarded).has_value());
}

}  // namespace
}  // namespace lippmann
