// A rendered data set of vision research: pictures, depth, disparity and parameters agree with each other.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "image/netpbm.hpp"
#include "image/read_image.hpp"
#include "layout/hci_parameters.hpp"
#include "tool.hpp"

namespace lippmann {
namespace {

using test::bytes_of;
using test::run_tool;
using test::TempDir;
namespace fs = std::filesystem;

struct View {
  Image colour, disparity;
};

View read_view(const fs::path& folder, int number) {
  const std::string name = std::to_string(number);
  return {read_image(folder / ("input_Cam00" + name + ".png")), read_pfm(folder / ("gt_disp_lowres_Cam00" + name + ".pfm"))};
}

/// The four pixels around a place, and how much each counts.
struct Neighbours {
  int x, y;
  float right, below;
};

bool neighbours_of(const Image& image, double x, double y, Neighbours& n) {
  n.x = static_cast<int>(std::floor(x - 0.5)), n.y = static_cast<int>(std::floor(y - 0.5));
  n.right = static_cast<float>(x - 0.5 - n.x), n.below = static_cast<float>(y - 0.5 - n.y);
  return n.x >= 0 && n.y >= 0 && n.x + 1 < image.width && n.y + 1 < image.height;
}

float interpolated(const Image& image, const Neighbours& n, int c) {
  const auto at = [&](int x, int y) { return image.pixel(n.x + x, n.y + y)[c]; };
  return (at(0, 0) * (1 - n.right) + at(1, 0) * n.right) * (1 - n.below) +
         (at(0, 1) * (1 - n.right) + at(1, 1) * n.right) * n.below;
}

struct Agreement {
  double psnr_db = 0.0, visible = 0.0;
};

/// View B from view A, whose eye stands (across, up) baselines beside it: every pixel of B looks at A where its own disparity
/// says, if A sees that point too: the disparities around that place are the same to 0.1 pixel.
Agreement warp(const View& a, const View& b, int across, int up) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < b.colour.height; ++y)
    for (int x = 0; x < b.colour.width; ++x) {
      const float d = *b.disparity.pixel(x, y);
      Neighbours n{};
      if (!neighbours_of(a.colour, x + 0.5 + across * d, y + 0.5 - up * d, n)) continue;
      bool seen = true;
      for (const int i : {0, 1, 2, 3}) seen = seen && std::abs(*a.disparity.pixel(n.x + i % 2, n.y + i / 2) - d) < 0.1f;
      if (!seen) continue;
      ++count;
      for (int c = 0; c < 3; ++c) sum += std::pow(interpolated(a.colour, n, c) - b.colour.pixel(x, y)[c], 2.0);
    }
  return {-10.0 * std::log10(sum / (3.0 * count)), static_cast<double>(count) / (b.colour.width * b.colour.height)};
}

/// 3 x 3 views whose neighbours differ by up to 5 pixels.
void make_data_set(const TempDir& dir, const std::string& scene) {
  const test::RunResult rendered =
      run_tool(dir, {"render", scene,     "--optics", "multiview", "--camera-grid", "--views", "3x3",
                     "--size", "576x432", "--frames", "0",         "--view-angle",  "1.5",     "--spp",
                     "16",     "--aov",   "depth",    "--format",  "png16",         "-o",      "r"});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  const test::RunResult converted = run_tool(dir, {"convert", "r/frame_0000.png", "hci", "--to", "hci"});
  ASSERT_EQ(converted.exit_code, 0) << converted.err;
}

TEST(Hci, disparity_of_one_view_gives_the_others) {
  const TempDir dir;
  make_data_set(dir, "gears");
  const View middle = read_view(dir / "hci", 4), right = read_view(dir / "hci", 5), above = read_view(dir / "hci", 1);
  const Agreement across = warp(middle, right, 1, 0), up = warp(middle, above, 0, 1);
  EXPECT_GT(across.visible, 0.8);
  EXPECT_GT(up.visible, 0.8);
  EXPECT_GE(across.psnr_db, 40.0);
  EXPECT_GE(up.psnr_db, 40.0);
  EXPECT_LT(warp(middle, right, -1, 0).psnr_db, across.psnr_db - 4.0) << "the sign matters";
  EXPECT_LT(warp(middle, above, 0, -1).psnr_db, up.psnr_db - 4.0);
}

TEST(Hci, depth_and_disparity_agree_with_the_parameters) {
  const TempDir dir;
  make_data_set(dir, "teapot");
  const HciParameters p = parse_hci_parameters(bytes_of(dir / "hci/parameters.cfg"), "parameters.cfg");
  EXPECT_EQ(p.columns, 3);
  const Image depth = read_pfm(dir / "hci/gt_depth_lowres.pfm"), disparity = read_pfm(dir / "hci/gt_disp_lowres.pfm");
  ASSERT_EQ(depth.width, 192);
  ASSERT_EQ(depth.height, 144);
  EXPECT_EQ(bytes_of(dir / "hci/gt_disp_lowres.pfm"), bytes_of(dir / "hci/gt_disp_lowres_Cam004.pfm")) << "the middle view's";
  for (std::size_t i = 0; i < depth.data.size(); ++i)
    ASSERT_NEAR(disparity.data[i], hci_disparity_px(p, static_cast<double>(depth.data[i])), 1e-3) << i;
}

TEST(Hci, what_is_not_known_is_said) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "teapot", "--optics", "multiview", "--camera-grid", "--views", "2x2", "--size", "64x64",
                           "--frames", "0", "-o", "r"})
                .exit_code,
            0);
  const test::RunResult no_depth = run_tool(dir, {"convert", "r/frame_0000.png", "hci", "--to", "hci"});
  EXPECT_EQ(no_depth.exit_code, 0);
  EXPECT_NE(no_depth.err.find("--aov depth"), std::string::npos) << no_depth.err;
  EXPECT_TRUE(fs::exists(dir / "hci/parameters.cfg"));
  fs::copy(dir / "r/frame_0000.png", dir / "alone.png");
  const test::RunResult no_cameras =
      run_tool(dir, {"convert", "alone.png", "h", "--from", "quilt", "--quilt", "2x2", "--to", "hci"});
  EXPECT_NE(no_cameras.err.find("report.json"), std::string::npos) << no_cameras.err;
  EXPECT_FALSE(fs::exists(dir / "h/parameters.cfg"));
}

TEST(Hci, conversion_that_fails_leaves_no_folder) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "teapot", "--optics", "multiview", "--views", "2x2", "--size", "64x64", "--frames", "0",
                           "-o", "r"})
                .exit_code,
            0);
  // Eyes at equal angles, which the format cannot say.
  EXPECT_EQ(run_tool(dir, {"convert", "r/frame_0000.png", "one", "--to", "hci"}).exit_code, 1);
  EXPECT_EQ(run_tool(dir, {"convert", "r", "all", "--to", "hci"}).exit_code, 1);
  EXPECT_FALSE(fs::exists(dir / "one"));
  EXPECT_FALSE(fs::exists(dir / "all"));
  fs::create_directory(dir / "was_there");
  EXPECT_EQ(run_tool(dir, {"convert", "r", "was_there", "--to", "hci"}).exit_code, 1);
  EXPECT_TRUE(fs::exists(dir / "was_there"));
}

TEST(Hci, data_set_brings_back_pictures_and_depth) {
  const TempDir dir;
  make_data_set(dir, "teapot");
  ASSERT_EQ(run_tool(dir, {"convert", "hci", "again", "--from", "hci", "--to", "hci", "--keep", "0-2x0-2"}).exit_code, 0);
  for (const auto& entry : fs::directory_iterator(dir / "hci")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".png")) {
      EXPECT_EQ(bytes_of(entry.path()), bytes_of(dir / "again" / name)) << name;
    }
    if (!name.ends_with(".pfm")) continue;
    const Image a = read_pfm(entry.path()), b = read_pfm(dir / "again" / name);
    for (std::size_t i = 0; i < a.data.size(); ++i) {
      if (std::isinf(a.data[i])) continue;
      ASSERT_NEAR(a.data[i], b.data[i], 1e-4) << name;  // metres or pixels, by way of floats of millimetres
    }
  }
}

}  // namespace
}  // namespace lippmann
