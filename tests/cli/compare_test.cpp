#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "image/png.hpp"
#include "support/pictures.hpp"
#include "tool.hpp"

namespace lippmann::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

/// Writes two frames each to the folders a and b. Only the first frames are equal.
void make_folders(const TempDir& dir) {
  for (const char* folder : {"a", "b"}) {
    std::filesystem::create_directory(dir / folder);
    write_png(dir / folder / "frame_0000.png", smooth_codes(32, 24));
  }
  write_png(dir / "a/frame_0001.png", smooth_codes(32, 24));
  write_png(dir / "b/frame_0001.png", smooth_codes(32, 24, 0.1));
}

TEST(CompareCommand, stdout_is_only_json) {
  const TempDir dir;
  make_folders(dir);
  const RunResult result = run_tool(dir, {"compare", "a", "b", "--json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const Json json = json_of(result.out);
  EXPECT_EQ(json["frames"].size(), 2u);
  EXPECT_TRUE(json["frames"][0]["psnr_db"].is_null());
  EXPECT_EQ(json["mean"]["psnr_db"], json["frames"][1]["psnr_db"]);
  EXPECT_EQ(json["identical"], false);
}

TEST(CompareCommand, table_ends_with_mean_and_worst) {
  const TempDir dir;
  make_folders(dir);
  const RunResult result = run_tool(dir, {"compare", "a", "b"});
  EXPECT_EQ(lines_of(result.out), 5u);
  EXPECT_THAT(result.out, HasSubstr("\nmean "));
  EXPECT_THAT(result.out, HasSubstr("\nworst "));
}

TEST(CompareCommand, frames_selects_frames) {
  const TempDir dir;
  make_folders(dir);
  const Json json = json_of(run_tool(dir, {"compare", "a", "b", "--frames", "1", "--json"}).out);
  ASSERT_EQ(json["frames"].size(), 1u);
  EXPECT_EQ(json["frames"][0]["name"], "frame_0001");
  std::filesystem::remove(dir / "b/frame_0001.png");
  EXPECT_EQ(json_of(run_tool(dir, {"compare", "a", "b", "--frames", "0", "--json"}).out)["identical"], true);
  expect_refusal(run_tool(dir, {"compare", "a", "b", "--frames", "0-1"}), 1, "b: has no frame 1, which --frames requests");
  expect_refusal(run_tool(dir, {"compare", "a/frame_0000.png", "b/frame_0000.png", "--frames", "0"}), 2, "--frames");
}

TEST(CompareCommand, csv_is_written_beside) {
  const TempDir dir;
  make_folders(dir);
  EXPECT_EQ(run_tool(dir, {"compare", "a", "b", "--csv", "c.csv"}).exit_code, 0);
  EXPECT_EQ(lines_of(bytes_of(dir / "c.csv")), 3u);
}

TEST(CompareCommand, impossible_comparison_is_one_message) {
  const TempDir dir;
  make_folders(dir);
  std::filesystem::remove(dir / "b/frame_0001.png");
  expect_refusal(run_tool(dir, {"compare", "a", "b"}), 1, "b: has no frame frame_0001");
  expect_refusal(run_tool(dir, {"compare", "a", "c"}), 1, "c: there is no such file or folder");
  expect_refusal(run_tool(dir, {"compare", "a", "a", "--csv", "a/frame_0000.png/c.csv"}), 1, "a/frame_0000.png: the folder");
  expect_refusal(run_tool(dir, {"compare", "a"}), 2, "TEST is required");
}

}  // namespace
}  // namespace lippmann::test
