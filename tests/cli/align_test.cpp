#include <gmock/gmock.h>

#include <cmath>

#include "align/align_module_file.hpp"
#include "cli/tool.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AlignTool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    expect_done(made(), {"render", "room", "--optics", "multiview", "--views", "5x1", "--size", "2000x300", "--view-angle", "4",
                         "--frames", "0", "--layout", "views", "-q", "-o", "r"});
  }

  void SetUp() override {
    if (!is_align_module_installed()) GTEST_SKIP() << "the module for OpenCV is not built: libopencv-calib3d-dev is missing";
    fs::copy(made() / "r/frame_0000", dir_ / "in");
  }

  static const TempDir& made() {
    static const TempDir dir;
    return dir;
  }

  TempDir dir_;
};

TEST_F(AlignTool, states_the_parallax_on_the_sheet) {
  const Words sheet{"--lpi", "40", "--dpi", "400", "--paper", "100x75mm"};
  const nlohmann::json report = report_of(dir_, Words{"align", "in", "out"} + sheet);
  ASSERT_EQ(report["pictures"].size(), 5u);
  EXPECT_EQ(report["middle"], 2);
  for (const auto& picture : report["pictures"]) {
    EXPECT_NEAR(picture["rotation_deg"].get<double>(), 0.0, 0.02);
    EXPECT_NEAR(picture["scale"].get<double>(), 1.0, 1e-3);
    EXPECT_NEAR(picture["shift_px"][1].get<double>(), 0.0, 0.2);
    EXPECT_TRUE(fs::exists(dir_ / picture["out"].get<std::string>()));
  }
  const nlohmann::json& parallax = report["parallax"];
  const int width = report["window"][2];
  EXPECT_NEAR(parallax["total_mm"].get<double>(), parallax["total_px"].get<double>() * 100.0 / width, 0.05);
  EXPECT_NEAR(parallax["total_lenses"].get<double>(), parallax["total_mm"].get<double>() * 40 / 25.4, 1e-6);
  EXPECT_EQ(parallax["resolved_lenses"], 4.0);
  const RunResult run = run_tool(dir_, Words{"align", "in", "-o", "again"} + sheet);
  EXPECT_THAT(run.out, HasSubstr("lens widths"));
  EXPECT_EQ(bytes_of(dir_ / "again/view_000.png"), bytes_of(dir_ / "out/view_000.png"));
}

TEST_F(AlignTool, warns_of_unresolved_parallax) {
  EXPECT_THAT(run_tool(dir_, {"align", "in", "out", "--lpi", "100", "--dpi", "400", "--paper", "A4"}).err,
              HasSubstr("lens widths. With 4 views, only 3 are possible"));
  EXPECT_EQ(run_tool(dir_, {"align", "in", "out", "--lpi", "4", "--dpi", "400", "--paper", "A7"}).err, "");
}

TEST_F(AlignTool, views_of_a_pair_equal_rendered_ones) {
  expect_done(dir_, {"convert", "in", "pair.png", "--from", "views", "--to", "stereo", "--keep", "0-4:4"});
  const nlohmann::json made = report_of(dir_, {"convert", "pair_2x1.png", "out", "--to", "views", "--views", "5x1"});
  EXPECT_LT(made["filled_share"].get<double>(), 0.01);
  for (const auto& [view, least_db] :
       {std::pair("0", 38.0), std::pair("1", 30.0), std::pair("2", 30.0), std::pair("4", 38.0)}) {
    const std::string name = "view_00" + std::string(view) + ".png";
    const nlohmann::json compared = report_of(dir_, {"compare", "in/" + name, "out/" + name});
    if (!compared["identical"]) {
      EXPECT_GT(compared["mean"]["psnr_db"].get<double>(), least_db) << name;
    }
  }
}

TEST_F(AlignTool, invalid_points_and_pairs_are_refused) {
  const auto refuse = [&](const Words& words, int code, const std::string& message) {
    expect_refusal(run_tool(dir_, words), code, message);
    EXPECT_FALSE(fs::exists(dir_ / "out"));
  };
  refuse({"align", "in", "out", "--focus", "3"}, 2, "--focus: '3' is not a point");
  refuse({"align", "in", "out", "--focus", "3,999"}, 2,
         "--focus: 3,999 lies outside the pictures; accepted: a point within 400x300 pixels");
  refuse({"align", "in", "out", "--display", "portrait", "--dpi", "300"}, 2, "--dpi: cannot be combined with --display");
  refuse({"align", "none", "out"}, 1, "none");
  Image8 plain{200, 60, std::vector<unsigned char>(std::size_t{3} * 200 * 60, 90)};
  write_picture(dir_ / "plain_2x1.png", plain);
  refuse({"convert", "plain_2x1.png", "out", "--to", "views", "--views", "5x1"}, 1, "too few to find their depth");
}

}  // namespace
}  // namespace lippmann::test
