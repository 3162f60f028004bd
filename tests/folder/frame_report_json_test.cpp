#include "folder/frame_report_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/sample_frame.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

TEST(FrameReportJson, frame_written_and_read_is_the_same) {
  const Json json = to_json(test::sample_frame());
  const auto back = frame_report_from_json(json);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(to_json(*back), json);
}

FrameReport shared_frame() {
  FrameReport frame = test::sample_frame();
  frame.kind = "shared";
  frame.psnr_at_least_db = 47.25;
  frame.estimated_block_psnr_db = 60.5;
  frame.estimated_psnr_at_eye_db = 50.25, frame.psnr_at_eye_at_least_db = 49.5;
  return frame;
}

TEST(FrameReportJson, shared_frame_written_and_read_keeps_its_errors) {
  const auto back = frame_report_from_json(to_json(shared_frame()));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->kind, "shared");
  EXPECT_EQ(back->estimated_psnr_db, 48.5);
  EXPECT_EQ(back->psnr_at_least_db, 47.25);
  EXPECT_EQ(back->estimated_block_psnr_db, 60.5);
  EXPECT_EQ(back->estimated_psnr_at_eye_db, 50.25);
  EXPECT_EQ(back->psnr_at_eye_at_least_db, 49.5);
}

TEST(FrameReportJson, shared_frame_without_one_of_its_errors_is_none) {
  for (const char* key : {"estimated_psnr_db", "psnr_at_least_db", "estimated_block_psnr_db"}) {
    Json json = to_json(shared_frame());
    json[key] = nullptr;
    EXPECT_FALSE(frame_report_from_json(json).has_value()) << key;
    json["kind"] = "full";
    EXPECT_TRUE(frame_report_from_json(json).has_value()) << key;
  }
}

// Folders of earlier versions go on: what they did not measure is unknown.
TEST(FrameReportJson, frame_of_an_earlier_version_lacks_what_it_did_not_measure) {
  Json json = to_json(shared_frame());
  for (const char* key : {"estimated_psnr_at_eye_db", "psnr_at_eye_at_least_db"}) json.erase(key);
  const auto back = frame_report_from_json(json);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->estimated_psnr_db, 48.5);
  EXPECT_FALSE(back->estimated_psnr_at_eye_db || back->psnr_at_eye_at_least_db);
}

TEST(FrameReportJson, frame_without_a_key_or_with_a_wrong_type_is_none) {
  Json json = to_json(test::sample_frame());
  json.erase("rays");
  EXPECT_FALSE(frame_report_from_json(json).has_value());
  EXPECT_FALSE(frame_report_from_json("frame").has_value());
  EXPECT_FALSE(frame_report_from_json(Json::value_t::discarded).has_value());
}

}  // namespace
}  // namespace lippmann
