// Data sets of vision research out of a render, and back.
#include <gtest/gtest.h>

#include <cmath>

#include "image/netpbm.hpp"
#include "tool.hpp"

namespace lippmann {
namespace {

using test::bytes_of;
using test::run_tool;
using test::TempDir;
namespace fs = std::filesystem;

/// 3 x 3 views with their depth.
void make_data_set(const TempDir& dir) {
  const test::RunResult rendered =
      run_tool(dir, {"render", "teapot", "--optics", "multiview", "--camera-grid", "--views", "3x3", "--size", "96x72",
                     "--frames", "0", "--view-angle", "1.5", "--aov", "depth", "--format", "png16", "-o", "r"});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  const test::RunResult converted = run_tool(dir, {"convert", "r/frame_0000.png", "hci", "--to", "hci"});
  ASSERT_EQ(converted.exit_code, 0) << converted.err;
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
  make_data_set(dir);
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
