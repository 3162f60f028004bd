// `--layout stereo` and `convert --to stereo`: pictures of two eyes.
#include <gmock/gmock.h>

#include "cli/tool.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Words small_pair(const std::string& folder) {
  return {"render", "teapot", "--layout", "stereo", "--frames", "3", "--viewing-distance", "600", "-o", folder};
}

Image8 codes_of(const std::filesystem::path& path) { return std::get<Image8>(read_picture(path)); }

TEST(Stereo, render_and_convert_agree_on_every_packing) {
  const TempDir dir;
  rendered(dir, small_pair("sbs") + Words{"--size", "128x36"}, "sbs");
  rendered(dir, small_pair("ou") + Words{"--size", "64x72", "--stereo", "over-under", "--right-first"}, "ou");
  rendered(dir, small_pair("rows") + Words{"--size", "64x36", "--stereo", "rows"}, "rows");
  const Words from_sbs{"convert", "sbs/frame_0003_2x1.png"};
  ASSERT_EQ(run_tool(dir, from_sbs + Words{"a.png", "--to", "stereo", "--stereo", "over-under", "--right-first"}).exit_code, 0);
  ASSERT_EQ(run_tool(dir, from_sbs + Words{"a.png", "--to", "stereo", "--stereo", "rows"}).exit_code, 0);
  EXPECT_EQ(bytes_of(dir / "ou/frame_0003_ou_rl.png"), bytes_of(dir / "a_ou_rl.png"));
  EXPECT_EQ(bytes_of(dir / "rows/frame_0003_rows.png"), bytes_of(dir / "a_rows.png"));
}

TEST(Stereo, pair_opens_as_two_views_without_a_flag) {
  const TempDir dir;
  rendered(dir, small_pair("sbs") + Words{"--size", "128x36"}, "sbs");
  const json views = report_of(dir, {"convert", "sbs", "views", "--to", "views"});
  EXPECT_EQ(views["views"], json({2, 1}));
  EXPECT_EQ(views["view_size"], json({64, 36}));
  EXPECT_EQ(run_tool(dir, {"replay", "sbs", "-o", "seen", "--eye=-31.5,0,600"}).exit_code, 0);
  EXPECT_EQ(codes_of(dir / "seen/eye_0003.png").rgb, codes_of(dir / "views/frame_0003/view_000.png").rgb)
      << "the left eye sees its own view";
}

TEST(Stereo, eyes_before_a_quilt_see_what_is_rendered_for_them) {
  const TempDir dir;
  // 16 eyes in a row, 10 mm apart on the same screen: those at +-25 mm are views of it.
  rendered(dir,
           {"render", "teapot", "--optics", "multiview", "--camera-grid", "--views", "16x1", "--size", "1024x36",
            "--view-angle", "15.189", "--frames", "3", "--viewing-distance", "600", "-o", "q"},
           "q");
  const json made = report_of(dir, {"convert", "q", "eyes", "--to", "stereo", "--ipd", "50", "--screen-width", "64"});
  EXPECT_EQ(made["view_size"], json({64, 36}));
  EXPECT_EQ(made["out_of_zone"], 0.0);
  rendered(dir, small_pair("sbs") + Words{"--size", "128x36", "--ipd", "50", "--screen-width", "64"}, "sbs");
  EXPECT_EQ(codes_of(dir / "sbs/frame_0003_2x1.png").rgb, codes_of(dir / "eyes/frame_0003_2x1.png").rgb);
}

TEST(Stereo, video_says_it_in_its_name) {
  const TempDir dir;
  const json report = report_of(dir, small_pair("out") + Words{"--size", "128x36", "--video", "a.mkv"});
  EXPECT_EQ(report["videos"], json::array({"a_2x1.mkv"}));
  ASSERT_EQ(run_tool(dir, {"encode", "out", "b.mkv"}).exit_code, 0);
  EXPECT_EQ(bytes_of(dir / "a_2x1.mkv"), bytes_of(dir / "b_2x1.mkv"));
}

TEST(Stereo, flags_of_stereo_are_refused_elsewhere) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--ipd", "60", "--frames", "0"}), 2, "--layout stereo");
  expect_refusal(run_tool(dir, {"render", "teapot", "--right-first", "--frames", "0"}), 2, "--right-first");
  expect_refusal(run_tool(dir, {"convert", "a.png", "b", "--to", "views", "--ipd", "60"}), 2, "--to stereo");
}

}  // namespace
}  // namespace lippmann::test
